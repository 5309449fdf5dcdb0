package org.dfra.drivers.camera.mjpeg;

import java.awt.image.BufferedImage;
import java.awt.image.Raster;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.time.Duration;
import java.util.Locale;
import java.util.function.Supplier;
import javax.imageio.ImageIO;
import javax.imageio.ImageReader;
import javax.imageio.stream.MemoryCacheImageInputStream;
import org.dfra.core.module.Diagnostics.DiagnosticFinding;
import org.dfra.core.module.LatestReading;
import org.dfra.drivers.device.DeviceLink;
import org.dfra.flow.sensor.CameraImage;

/** Checks whether an image can be decoded and has visible content. */
final class ImageDiagnostics {

  static final String IMAGE = "image";

  private final DeviceLink deviceLink;
  private final MjpegProtocol protocol;
  private final Supplier<CameraImage> images;

  /**
   * @param images supplies the last image; throws if there is none
   */
  ImageDiagnostics(DeviceLink line, MjpegProtocol protocol, Supplier<CameraImage> images) {
    this.deviceLink = line;
    this.protocol = protocol;
    this.images = images;
  }

  /** Waits for the next image, decodes it, and checks that it has visible content. */
  DiagnosticFinding checkNextImage() throws InterruptedException {
    DiagnosticFinding link = deviceLink.link();
    if (!link.passed()) {
      return link;
    }
    Duration patience = protocol.livenessTimeout();
    if (!deviceLink.eventCounter().await(IMAGE, deviceLink.eventCounter().total(IMAGE), patience)) {
      return new DiagnosticFinding(
          false, "no image has come within " + LatestReading.seconds(patience));
    }
    return of(images.get());
  }

  /** Checks one image. */
  static DiagnosticFinding of(CameraImage image) {
    BufferedImage decoded;
    ImageReader reader = ImageIO.getImageReadersByMIMEType(image.mediaType()).next();
    try (var in = new MemoryCacheImageInputStream(new ByteArrayInputStream(image.data()))) {
      reader.setInput(in);
      decoded = reader.read(0);
    } catch (IOException | RuntimeException e) { // the JDK's decoders throw both for damaged data
      return new DiagnosticFinding(false, "the image cannot be decoded: " + e.getMessage());
    } finally {
      reader.dispose();
    }
    Raster pixels = decoded.getRaster();
    int least = Integer.MAX_VALUE;
    int most = Integer.MIN_VALUE;
    int[] row = new int[pixels.getWidth() * pixels.getNumBands()];
    for (int y = 0; y < pixels.getHeight(); y++) {
      for (int sample : pixels.getPixels(0, y, pixels.getWidth(), 1, row)) {
        least = Math.min(least, sample);
        most = Math.max(most, sample);
      }
    }
    boolean isThermal = image.band() == CameraImage.Band.THERMAL;
    String levels =
        isThermal
            ? String.format(
                Locale.ROOT, "%.2f to %.2f °C", least / 100.0 - 273.15, most / 100.0 - 273.15)
            : "levels " + least + " to " + most;
    String found =
        image.width() + " × " + image.height() + " pixels, " + image.size() + " bytes, " + levels;
    return least < most
        ? new DiagnosticFinding(true, found)
        : new DiagnosticFinding(false, found + ": all of it is the same; is the lens covered?");
  }
}
