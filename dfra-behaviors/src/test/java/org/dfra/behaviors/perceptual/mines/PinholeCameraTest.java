package org.dfra.behaviors.perceptual.mines;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Objects;
import java.util.Random;
import org.assertj.core.data.Offset;
import org.dfra.behaviors.perceptual.mines.MineObservation.GroundPoint;
import org.dfra.behaviors.perceptual.mines.PinholeCamera.Pixel;
import org.dfra.geometry.Transform;
import org.junit.jupiter.api.Test;

class PinholeCameraTest {

  private static final Offset<Double> EXACT = within(1e-9);

  @Test
  void aLevelCameraSeesByTheRatios() {
    PinholeCamera camera = new PinholeCamera(Transform.translation(0, 0, 1), 320, 240, 200);
    // 2 m ahead, 0.5 m to the left, on the ground 1 m below: 50 columns left, 100 rows below.
    Pixel pixel = Objects.requireNonNull(camera.project(2, 0.5, 0));
    assertThat(pixel.column()).isCloseTo(160 - 50, EXACT);
    assertThat(pixel.row()).isCloseTo(120 + 100, EXACT);
  }

  @Test
  void aCameraThatLooksDownMeetsTheGroundWhereItsAxisDoes() {
    PinholeCamera camera = new PinholeCamera(Transform.of(0.35, 0, 0.7, 0, 0.5, 0), 320, 240, 276);
    GroundPoint spot = Objects.requireNonNull(camera.backProject(new Pixel(160, 120), 0));
    assertThat(spot.x()).isCloseTo(0.35 + 0.7 / Math.tan(0.5), EXACT);
    assertThat(spot.y()).isCloseTo(0, EXACT);
  }

  @Test
  void aCameraTurnedToTheLeftSeesTheLeft() {
    PinholeCamera camera =
        new PinholeCamera(Transform.of(0, 0, 1, 0, 0.5, Math.PI / 2), 320, 240, 276);
    GroundPoint spot = Objects.requireNonNull(camera.backProject(new Pixel(160, 120), 0));
    assertThat(spot.x()).isCloseTo(0, EXACT);
    assertThat(spot.y()).isCloseTo(1 / Math.tan(0.5), EXACT);
  }

  @Test
  void nothingIsSeenBehindOrAboveTheHorizon() {
    PinholeCamera camera = new PinholeCamera(Transform.translation(0, 0, 1), 320, 240, 200);
    assertThat(camera.project(-1, 0, 0)).isNull();
    assertThat(camera.backProject(new Pixel(160, 119), 0)).isNull();
  }

  @Test
  void backAndForthIsTheSame() {
    long seed = Long.getLong("dfra.seed", new Random().nextLong());
    Random random = new Random(seed);
    for (int i = 0; i < 1000; i++) {
      Transform mount =
          Transform.of(
              random.nextDouble(),
              random.nextDouble(),
              0.3 + random.nextDouble(),
              random.nextGaussian() / 4,
              random.nextDouble(),
              6 * random.nextDouble());
      PinholeCamera camera = new PinholeCamera(mount, 320, 240, 276);
      Pixel pixel = new Pixel(320 * random.nextDouble(), 240 * random.nextDouble());
      double height = 0.2 * random.nextDouble();
      GroundPoint spot = camera.backProject(pixel, height);
      if (spot != null && Math.hypot(spot.x(), spot.y()) < 100) {
        Pixel again = Objects.requireNonNull(camera.project(spot.x(), spot.y(), height));
        assertThat(again.column())
            .as("-Ddfra.seed=" + seed + ", round " + i)
            .isCloseTo(pixel.column(), within(1e-6));
        assertThat(again.row()).isCloseTo(pixel.row(), within(1e-6));
      }
    }
  }
}
