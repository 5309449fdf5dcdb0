package org.dfra.behaviors.perceptual.range;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import org.dfra.flow.sensor.Odometry;
import org.dfra.flow.sensor.RangeScan;
import org.junit.jupiter.api.Test;

class GhostFilterTest {

  private static final Instant BEGIN = Instant.EPOCH;
  private static final int BEAMS = 181;
  private static final double STEP = Math.PI / 180;
  private static final float NOTHING = Float.POSITIVE_INFINITY;

  private final GhostFilter filter = new GhostFilter(5, Duration.ofMillis(90));

  private static RangeScan scan(double seconds, float... ranges) {
    return new RangeScan(
        at(seconds), "atrv1/laser", -(ranges.length - 1) / 2.0 * STEP, STEP, 0, 0, 80, ranges);
  }

  private static Instant at(double seconds) {
    return BEGIN.plusNanos(Math.round(seconds * 1e9));
  }

  private static Odometry odometry(double seconds, double x, double y, double yaw) {
    return new Odometry(at(seconds), "atrv1/odom", "atrv1/base_link", x, y, yaw, 0, 0);
  }

  private static float[] all(float range) {
    float[] ranges = new float[BEAMS];
    Arrays.fill(ranges, range);
    return ranges;
  }

  private static float[] with(float range, int beam, float other) {
    float[] ranges = all(range);
    ranges[beam] = other;
    return ranges;
  }

  @Test
  void saysNothingBeforeItHasSeenThreeScans() {
    assertThat(filter.take(scan(0, all(5)))).isEmpty();
    assertThat(filter.take(scan(0.1, all(5)))).isEmpty();
    assertThat(filter.take(scan(0.2, all(5)))).isPresent();
  }

  @Test
  void takesOutWhatOneOrTwoScansShowAndKeepsWhatStays() {
    for (int i = 0; i < 5; i++) {
      filter.take(scan(i * 0.1, all(8)));
    }
    for (int i = 5; i < 7; i++) {
      float[] seen = filter.take(scan(i * 0.1, with(8, 90, 1))).orElseThrow();
      assertThat(seen[90]).as("scan %s", i).isEqualTo(8);
    }
    float[] third = filter.take(scan(0.7, with(8, 90, 1))).orElseThrow();
    assertThat(third[90]).as("what stays is no ghost").isEqualTo(1);
    assertThat(third[89]).isEqualTo(8);
  }

  @Test
  void aGhostThatLastsForManyScansOfAFastLaserIsOneStill() {
    for (int i = 0; i <= 10; i++) {
      filter.take(scan(i * 0.1, all(8)));
    }
    for (double t = 1.01; t < 1.15; t += 0.01) {
      assertThat(filter.take(scan(t, with(8, 90, 1))).orElseThrow()[90]).as("%s", t).isEqualTo(8);
    }
  }

  @Test
  void keepsARealObstacleInPlaceWhileTheRobotTurns() {
    float[] seen = null;
    for (int i = 0; i < 12; i++) {
      double yaw = i * 5 * STEP; // to the left: what is ahead moves to the right
      filter.take(odometry(i * 0.1, 0, 0, yaw));
      seen = filter.take(scan(i * 0.1, with(8, 120 - 5 * i, 2))).orElse(seen);
    }
    assertThat(seen[120 - 55]).isEqualTo(2);
    assertThat(seen[120 - 50]).as("where it was a scan ago").isEqualTo(8);
  }

  @Test
  void shortensWhatItSawByTheWayThatItHasCome() {
    float[] seen = null;
    for (int i = 0; i < 9; i++) {
      assertThat(filter.take(odometry(i * 0.1, i * 0.07, 0, 0))).isEqualTo(i == 0);
      seen = filter.take(scan(i * 0.1, with(NOTHING, 90, 5 - i * 0.07f))).orElse(seen);
    }
    assertThat(seen[90]).isCloseTo(5 - 8 * 0.07f, within(1e-5f));
    assertThat(seen[10]).isEqualTo(NOTHING);
  }

  @Test
  void followsTurnsThatAreNotWrapped() {
    float[] seen = null;
    for (int i = 0; i < 9; i++) {
      filter.take(odometry(i * 0.1, 0, 0, Math.PI - 0.1 + i * 0.03));
      seen = filter.take(scan(i * 0.1, all(6))).orElse(seen);
    }
    assertThat(seen[90]).isEqualTo(6);
  }

  @Test
  void countsWhatFailedAsUnknownAndWhatIsTooNearAsNear() {
    float[] seen = null;
    for (int i = 0; i < 5; i++) {
      float[] ranges = all(4);
      ranges[3] = Float.NaN;
      ranges[4] = i % 2 == 0 ? Float.NaN : 4; // failed three times of five
      ranges[5] = i % 2 == 0 ? 4 : Float.NaN; // twice
      ranges[6] = Float.NEGATIVE_INFINITY;
      ranges[7] = NOTHING;
      seen = filter.take(scan(i * 0.1, ranges)).orElse(seen);
    }
    assertThat(seen[3]).isNaN();
    assertThat(seen[4]).isNaN();
    assertThat(seen[5]).isEqualTo(4);
    assertThat(seen[6]).isEqualTo(Float.NEGATIVE_INFINITY);
    assertThat(seen[7]).isEqualTo(NOTHING);
  }

  @Test
  void restartsWhereTheScansChangeTheirShapeOrTheTimeGoesBack() {
    for (int i = 0; i < 5; i++) {
      filter.take(scan(i * 0.1, all(8)));
    }
    assertThat(filter.take(scan(0.5, new float[361]))).as("another resolution").isEmpty();
    for (int i = 6; i < 9; i++) {
      filter.take(scan(i * 0.1, new float[361]));
    }
    assertThat(filter.take(scan(0.1, new float[361]))).as("the clock was set back").isEmpty();
  }

  @Test
  void restartsWhereTheOdometryRestarts() {
    for (int i = 0; i < 6; i++) {
      filter.take(odometry(i * 0.1, 50 + i * 0.05, 3, 0));
      filter.take(scan(i * 0.1, all(8)));
    }
    assertThat(filter.take(odometry(0.6, 0, 0, 0))).as("its process was killed").isTrue();
    assertThat(filter.take(scan(0.6, with(8, 90, 1))))
        .as("otherwise older scans would outvote a new obstacle by 50 m")
        .isEmpty();
  }

  @Test
  void worksWithoutAnyTimeBetweenItsScans() {
    GhostFilter dense = new GhostFilter(5, Duration.ZERO);
    float[] seen = null;
    for (int i = 0; i < 5; i++) {
      seen = dense.take(scan(i * 0.02, all(3))).orElse(seen);
    }
    assertThat(seen).isNotNull();
    assertThat(seen[0]).isEqualTo(3);
  }

  @Test
  void saysHowOldTheScanIsThatDecidesAboutWhatComesNearer() {
    for (int i = 0; i < 5; i++) {
      filter.take(scan(i * 0.1, all(8 - i)));
    }
    assertThat(filter.lag()).isCloseTo(0.2, within(1e-9));
    float[] seen = filter.take(scan(0.9, all(1))).orElseThrow(); // 0.4 s passed without a scan
    assertThat(seen[90]).as("that of 0.3 s").isEqualTo(5);
    assertThat(filter.lag()).isCloseTo(0.6, within(1e-9));
    GhostFilter none = new GhostFilter(1, Duration.ofMillis(90));
    none.take(scan(0, all(8)));
    none.take(scan(0.5, all(7)));
    assertThat(none.lag()).as("it filters nothing").isZero();
  }

  @Test
  void ofOneScanItFiltersNothing() {
    GhostFilter none = new GhostFilter(1, Duration.ofMillis(90));
    assertThat(none.take(scan(0, with(8, 90, 1))).orElseThrow()[90]).isEqualTo(1);
    assertThat(none.take(scan(0.1, all(8))).orElseThrow()[90]).isEqualTo(8);
  }

  /** The same by a list of everything that each scan says of each beam, sorted. */
  @Test
  void isTheMedianOfWhatEachScanSaysOfEachBeam() {
    long seed = System.nanoTime();
    Random random = new Random(seed);
    for (int round = 0; round < 30; round++) {
      int beams = 3 + random.nextInt(40);
      int depth = 1 + random.nextInt(7);
      GhostFilter some = new GhostFilter(depth, Duration.ofMillis(90));
      List<RangeScan> scans = new ArrayList<>();
      List<Odometry> places = new ArrayList<>();
      for (int i = 0; i < 12; i++) {
        double time = i * 0.1;
        double last = places.isEmpty() ? 0 : places.get(i - 1).yaw();
        places.add(
            odometry(
                time,
                i * 0.05,
                random.nextDouble() * 0.05,
                last + (random.nextDouble() - 0.5) * 6 * STEP));
        float[] ranges = new float[beams];
        for (int beam = 0; beam < beams; beam++) {
          ranges[beam] = any(random);
        }
        scans.add(scan(time, ranges));
        some.take(places.get(i));
        float[] seen = some.take(scans.get(i)).orElse(null);
        int first = Math.max(0, i - depth + 1);
        if (i + 1 - first < depth / 2 + 1) {
          assertThat(seen).as("seed %s", seed).isNull();
          continue;
        }
        assertThat(seen).as("seed %s", seed).isNotNull();
        for (int beam = 0; beam < beams; beam++) {
          float expected = brute(scans.subList(first, i + 1), places.subList(first, i + 1), beam);
          assertThat(seen[beam])
              .as("seed %s, round %s, scan %s, beam %s", seed, round, i, beam)
              .isCloseTo(expected, Float.isFinite(expected) ? within(1e-4f) : within(0f));
        }
      }
    }
  }

  private static float any(Random random) {
    return switch (random.nextInt(8)) {
      case 0 -> Float.NaN;
      case 1 -> NOTHING;
      case 2 -> Float.NEGATIVE_INFINITY;
      default -> random.nextFloat() * 10;
    };
  }

  private static float brute(List<RangeScan> scans, List<Odometry> places, int beam) {
    Odometry now = places.get(places.size() - 1);
    List<Float> ranges = new ArrayList<>();
    for (int i = 0; i < scans.size(); i++) {
      RangeScan scan = scans.get(i);
      Odometry then = places.get(i);
      long old = beam + Math.round(Math.rint((now.yaw() - then.yaw()) / STEP));
      if (old < 0 || old >= scan.beams() || Float.isNaN(scan.range((int) old))) {
        continue;
      }
      double bearing = then.yaw() + scan.angle((int) old);
      double come =
          (now.x() - then.x()) * Math.cos(bearing) + (now.y() - then.y()) * Math.sin(bearing);
      float range = scan.range((int) old);
      ranges.add(Float.isFinite(range) ? (float) Math.max(0, range - come) : range);
    }
    if (2 * ranges.size() <= scans.size()) {
      return Float.NaN;
    }
    Collections.sort(ranges);
    return ranges.get((ranges.size() - 1) / 2);
  }
}
