package org.dfra.sim.device.camera;

import java.time.Instant;
import org.dfra.sim.physics.CameraInput;

/** What a camera sees that looks at nothing of this world: every pixel is known. */
final class TestPattern {

  private TestPattern() {}

  /** Smooth ramps of red to the right and of green downwards; blue tells the frame. */
  static CameraInput light(int width, int height) {
    return time -> {
      int[] samples = new int[width * height];
      for (int i = 0; i < samples.length; i++) {
        int x = i % width;
        int y = i / width;
        samples[i] = red(x, width) << 16 | green(y, height) << 8 | blue(time);
      }
      return new CameraInput.Frame(width, height, samples);
    };
  }

  static int red(int x, int width) {
    return 255 * x / (width - 1);
  }

  static int green(int y, int height) {
    return 255 * y / (height - 1);
  }

  static int blue(Instant time) {
    return (int) (time.toEpochMilli() / 100 % 200);
  }

  /** Each pixel has a temperature of its own, hundredths of a kelvin around 20 °C. */
  static CameraInput heat(int width, int height) {
    return time -> {
      int[] samples = new int[width * height];
      for (int i = 0; i < samples.length; i++) {
        samples[i] = centikelvin(i, time);
      }
      return new CameraInput.Frame(width, height, samples);
    };
  }

  static int centikelvin(int pixel, Instant time) {
    return 20_000 + (int) ((pixel * 7919L + time.getEpochSecond()) % 40_000);
  }
}
