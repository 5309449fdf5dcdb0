package org.dfra.behaviors.perceptual.mines;

import java.awt.image.BufferedImage;
import java.awt.image.DataBuffer;
import java.awt.image.Raster;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.util.ArrayList;
import java.util.Iterator;
import java.util.List;
import java.util.Optional;
import javax.imageio.ImageIO;
import javax.imageio.ImageReader;
import javax.imageio.stream.MemoryCacheImageInputStream;
import org.dfra.behaviors.perceptual.mines.DetectionWindow.PixelRect;
import org.dfra.flow.sensor.CameraImage;
import org.dfra.flow.sensor.CameraImage.Band;

/**
 * An image, decoded. Immutable.
 *
 * @param band its spectral band
 * @param channels visible: red, green and blue, 0 to 255; thermal: one, hundredths of a kelvin
 */
record DecodedImage(Band band, List<DecodedImage.SummedTable> channels) {

  DecodedImage {
    channels = List.copyOf(channels);
  }

  /**
   * Decodes a camera's image.
   *
   * @return empty if it is no complete JPEG or PNG, its size differs from its declaration, or it is
   *     thermal and not 16-bit grey
   */
  static Optional<DecodedImage> decode(CameraImage image) {
    Optional<BufferedImage> read = read(image);
    if (read.isEmpty()
        || read.get().getWidth() != image.width()
        || read.get().getHeight() != image.height()) {
      return Optional.empty();
    }
    return image.band() == Band.THERMAL ? heat(read.get()) : Optional.of(light(read.get()));
  }

  private static Optional<BufferedImage> read(CameraImage image) {
    Iterator<ImageReader> readers = ImageIO.getImageReadersByMIMEType(image.mediaType());
    if (!readers.hasNext()) {
      return Optional.empty();
    }
    ImageReader reader = readers.next();
    try (MemoryCacheImageInputStream bytes =
        new MemoryCacheImageInputStream(new ByteArrayInputStream(image.data()))) {
      reader.setInput(bytes, true, true);
      if (reader.getWidth(0) != image.width() || reader.getHeight(0) != image.height()) {
        return Optional.empty(); // before memory is allocated
      }
      return Optional.of(reader.read(0));
    } catch (IOException | RuntimeException e) { // the JDK's readers throw either on invalid data
      return Optional.empty();
    } finally {
      reader.dispose();
    }
  }

  private static Optional<DecodedImage> heat(BufferedImage image) {
    Raster raster = image.getRaster();
    if (raster.getNumBands() != 1 || raster.getTransferType() != DataBuffer.TYPE_USHORT) {
      return Optional.empty();
    }
    int width = image.getWidth();
    int height = image.getHeight();
    int[] samples = raster.getSamples(0, 0, width, height, 0, new int[width * height]);
    return Optional.of(
        new DecodedImage(Band.THERMAL, List.of(new SummedTable(width, height, samples))));
  }

  private static DecodedImage light(BufferedImage image) {
    int width = image.getWidth();
    int height = image.getHeight();
    int[] colours = image.getRGB(0, 0, width, height, null, 0, width);
    List<SummedTable> channels = new ArrayList<>();
    for (int shift = 16; shift >= 0; shift -= 8) {
      int[] samples = new int[colours.length];
      for (int i = 0; i < samples.length; i++) {
        samples[i] = colours[i] >> shift & 0xFF;
      }
      channels.add(new SummedTable(width, height, samples));
    }
    return new DecodedImage(Band.VISIBLE, channels);
  }

  /**
   * The summed-area table of one channel: the mean of any rectangle takes four look-ups. Source: F.
   * C. Crow, "Summed-area tables for texture mapping", SIGGRAPH (1984). Immutable.
   */
  static final class SummedTable {

    private final int width;
    private final int height;
    private final long[] sums; // of all above and left of a pixel's upper left corner

    /**
     * @param samples row by row from the upper left, width × height of them
     */
    SummedTable(int width, int height, int[] samples) {
      this.width = width;
      this.height = height;
      this.sums = new long[(width + 1) * (height + 1)];
      for (int row = 0; row < height; row++) {
        long sum = 0;
        for (int column = 0; column < width; column++) {
          sum += samples[row * width + column];
          sums[(row + 1) * (width + 1) + column + 1] = sums[row * (width + 1) + column + 1] + sum;
        }
      }
    }

    int width() {
      return width;
    }

    int height() {
      return height;
    }

    /** Mean of the samples in a rectangle inside the image. */
    double mean(PixelRect box) {
      int above = box.top() * (width + 1);
      int below = box.bottom() * (width + 1);
      long sum =
          sums[below + box.right()]
              - sums[above + box.right()]
              - sums[below + box.left()]
              + sums[above + box.left()];
      return (double) sum / box.pixels();
    }
  }
}
