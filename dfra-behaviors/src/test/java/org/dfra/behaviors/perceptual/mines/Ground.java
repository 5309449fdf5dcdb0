package org.dfra.behaviors.perceptual.mines;

import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.time.Instant;
import java.util.Random;
import java.util.function.ToIntFunction;
import javax.imageio.ImageIO;
import org.dfra.behaviors.perceptual.mines.MineObservation.GroundPoint;
import org.dfra.behaviors.perceptual.mines.PinholeCamera.Pixel;
import org.dfra.flow.sensor.CameraImage;
import org.dfra.flow.sensor.CameraImage.Band;
import org.dfra.geometry.Transform;
import org.jspecify.annotations.Nullable;

/** Images of a plane that is painted, by a camera that looks down 0.5 rad from 0.7 m. */
final class Ground {

  static final Transform MOUNT = Transform.of(0.35, 0, 0.7, 0, 0.5, 0);
  static final PinholeCamera CAMERA = new PinholeCamera(MOUNT, 320, 240, 276);
  static final int GRASS = 0x526C32;
  static final int OLIVE = 0x3F4526;
  static final int WARM = 30_315;

  private Ground() {}

  static CameraImage heat(Random random, ToIntFunction<GroundPoint> paint) {
    BufferedImage image = new BufferedImage(320, 240, BufferedImage.TYPE_USHORT_GRAY);
    paint(
        paint,
        (x, y, sample) ->
            image.getRaster().setSample(x, y, 0, sample + (int) (8 * random.nextGaussian())));
    return image(Band.THERMAL, "image/png", encoded(image, "png"));
  }

  static CameraImage light(ToIntFunction<GroundPoint> paint) {
    BufferedImage image = new BufferedImage(320, 240, BufferedImage.TYPE_INT_RGB);
    paint(paint, image::setRGB);
    return image(Band.VISIBLE, "image/jpeg", encoded(image, "jpeg"));
  }

  static CameraImage image(Band band, String type, byte[] data) {
    return new CameraImage(Instant.EPOCH, "robot/camera", band, 320, 240, 276, type, data);
  }

  private interface Dots {
    void set(int x, int y, int sample);
  }

  private static void paint(ToIntFunction<GroundPoint> paint, Dots dots) {
    for (int y = 0; y < 240; y++) {
      for (int x = 0; x < 320; x++) {
        @Nullable GroundPoint spot = CAMERA.backProject(new Pixel(x + 0.5, y + 0.5), 0);
        dots.set(x, y, paint.applyAsInt(spot == null ? new GroundPoint(1e3, 0) : spot));
      }
    }
  }

  static byte[] encoded(BufferedImage image, String format) {
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    try {
      if (!ImageIO.write(image, format, out)) {
        throw new IllegalStateException("this JDK writes no " + format);
      }
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
    return out.toByteArray();
  }
}
