package org.dfra.sim.device.camera;

import java.awt.image.BufferedImage;
import java.awt.image.DataBufferByte;
import java.awt.image.DataBufferUShort;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import javax.imageio.IIOImage;
import javax.imageio.ImageIO;
import javax.imageio.ImageWriteParam;
import javax.imageio.ImageWriter;
import javax.imageio.stream.MemoryCacheImageOutputStream;
import org.dfra.flow.sensor.CameraImage.Band;
import org.dfra.sim.physics.CameraInput.Frame;

/**
 * Encodes frames as a camera does; the same frame gives the same bytes. Needs no display. Confined
 * to one thread.
 */
public final class FrameEncoder {

  private static final float QUALITY = 0.85f;
  private static final int MOST_LEVEL = 0xFFFF;

  private final boolean isThermal;
  private final ImageWriter writer;
  private final ImageWriteParam settings;

  /**
   * @param band thermal for 16-bit grey frames, encoded as PNG; visible for colour, as JPEG
   */
  public FrameEncoder(Band band) {
    this.isThermal = band == Band.THERMAL;
    this.writer = ImageIO.getImageWritersByFormatName(isThermal ? "png" : "jpeg").next();
    this.settings = writer.getDefaultWriteParam();
    if (!isThermal) {
      settings.setCompressionMode(ImageWriteParam.MODE_EXPLICIT);
      settings.setCompressionQuality(QUALITY);
    }
  }

  /** {@code image/png} or {@code image/jpeg}. */
  public String mediaType() {
    return isThermal ? "image/png" : "image/jpeg";
  }

  /** The bytes of a frame. */
  public byte[] encode(Frame frame) {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    try (MemoryCacheImageOutputStream out = new MemoryCacheImageOutputStream(bytes)) {
      writer.setOutput(out);
      writer.write(
          null, new IIOImage(isThermal ? heat(frame) : light(frame), null, null), settings);
    } catch (IOException e) {
      throw new UncheckedIOException("a frame cannot be encoded: " + e.getMessage(), e);
    } finally {
      writer.reset();
    }
    return bytes.toByteArray();
  }

  /** Bytes in the order that JPEG's writer copies without conversion. */
  private static BufferedImage light(Frame frame) {
    BufferedImage image =
        new BufferedImage(frame.width(), frame.height(), BufferedImage.TYPE_3BYTE_BGR);
    byte[] bytes = ((DataBufferByte) image.getRaster().getDataBuffer()).getData();
    int at = 0;
    for (int sample : frame.samples()) {
      bytes[at++] = (byte) sample;
      bytes[at++] = (byte) (sample >> 8);
      bytes[at++] = (byte) (sample >> 16);
    }
    return image;
  }

  private static BufferedImage heat(Frame frame) {
    BufferedImage image =
        new BufferedImage(frame.width(), frame.height(), BufferedImage.TYPE_USHORT_GRAY);
    short[] levels = ((DataBufferUShort) image.getRaster().getDataBuffer()).getData();
    for (int i = 0; i < levels.length; i++) {
      levels[i] = (short) Math.max(0, Math.min(MOST_LEVEL, frame.samples()[i]));
    }
    return image;
  }
}
