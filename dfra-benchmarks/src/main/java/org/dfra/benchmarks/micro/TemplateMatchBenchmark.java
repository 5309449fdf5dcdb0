package org.dfra.benchmarks.micro;

import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.util.List;
import java.util.concurrent.TimeUnit;
import javax.imageio.ImageIO;
import javax.imageio.stream.MemoryCacheImageInputStream;
import org.dfra.behaviors.perceptual.mines.ImageMineDetector;
import org.dfra.behaviors.perceptual.mines.ImageMineDetector.ImageDetections;
import org.dfra.behaviors.perceptual.mines.ImageMineDetectorSettings;
import org.dfra.flow.sensor.CameraImage.Band;
import org.dfra.geometry.Transform;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.State;

/**
 * The mine detector's search of one image: it decodes the image, and matches the template of a mine
 * (the mine and sixteen boxes around it) at all positions on the ground in front of the robot, 5 cm
 * apart. The images are those of {@link MineLane}. Decoding by the JDK alone is measured too, since
 * much of the time is decoding. Microseconds.
 */
@State(Scope.Thread)
@BenchmarkMode(Mode.SampleTime)
@OutputTimeUnit(TimeUnit.MICROSECONDS)
public class TemplateMatchBenchmark {

  private final ImageSeries light = new ImageSeries(Band.VISIBLE);
  private final ImageSeries heat = new ImageSeries(Band.THERMAL);

  /** For JMH. */
  public TemplateMatchBenchmark() {}

  /** The images of one camera, in turn. */
  private static final class ImageSeries {

    private final List<MineLane.LabelledImage> images;
    private final List<byte[]> encoded;
    private final Transform mount = MineLane.mount();
    private final ImageMineDetector detector =
        new ImageMineDetector(ImageMineDetectorSettings.DEFAULT);
    private int next;

    ImageSeries(Band band) {
      this.images = MineLane.images(band);
      this.encoded = images.stream().map(each -> each.image().data()).toList(); // data() copies
    }

    ImageDetections search() {
      return detector.detect(images.get(next()).image(), mount).orElseThrow();
    }

    BufferedImage decode() throws IOException {
      return ImageIO.read( // closes the stream
          new MemoryCacheImageInputStream(new ByteArrayInputStream(encoded.get(next()))));
    }

    private int next() {
      next = (next + 1) % images.size();
      return next;
    }
  }

  /** The images of a camera. The first search is that of the second image. */
  List<MineLane.LabelledImage> images(Band band) {
    return (band == Band.THERMAL ? heat : light).images;
  }

  /** The search of an image in visible light. */
  @Benchmark
  public ImageDetections light() {
    return light.search();
  }

  /**
   * Only the decoding of such an image, JPEG.
   *
   * @throws IOException never
   */
  @Benchmark
  public BufferedImage lightDecoded() throws IOException {
    return light.decode();
  }

  /** The search of a thermal image. */
  @Benchmark
  public ImageDetections heat() {
    return heat.search();
  }

  /**
   * Only the decoding of such an image, PNG of 16 bits.
   *
   * @throws IOException never
   */
  @Benchmark
  public BufferedImage heatDecoded() throws IOException {
    return heat.decode();
  }
}
