package org.dfra.behaviors.perceptual.pose;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatCode;

import java.time.Instant;
import java.util.Random;
import org.dfra.behaviors.perceptual.pose.Field.Errors;
import org.dfra.behaviors.perceptual.pose.PositionEstimatorImpl.TrackerKind;
import org.dfra.flow.perceptual.PoseEstimate;
import org.dfra.flow.sensor.AngularRate;
import org.dfra.flow.sensor.GpsFix;
import org.dfra.flow.sensor.Odometry;
import org.dfra.geometry.GeoPosition;
import org.dfra.geometry.Transform;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** What holds for every kind of tracker. */
class AnyTrackerTest {

  private static final double[] ODD = {
    0, -0.0, 1e-300, 1, -1, 3.2, 50, -1e3, 1e6, -1e9, 1e155, -1e300, Double.MIN_VALUE
  };
  private static final Instant[] MOMENTS = {
    Instant.EPOCH, Instant.MIN, Instant.MAX, Field.START.plusSeconds(3600), Field.START
  };

  @ParameterizedTest
  @EnumSource
  void saysNothingBeforeTheFirstFix(TrackerKind kind) {
    PoseTracker tracker = kind.create(TrackerSettings.DEFAULT, "r/map", null);
    Field field = new Field(1, Errors.WHITE, 20);
    Ride ride = new Ride(field, tracker);
    ride.without(received -> received.antenna() >= 0);
    ride.go(19);
    assertThat(tracker.estimate(field.host(19))).isEmpty();
  }

  @ParameterizedTest
  @EnumSource
  void takesTheFirstPositionForItsDatum(TrackerKind kind) {
    PoseTracker tracker = kind.create(TrackerSettings.DEFAULT, "r/map", null);
    Field field = new Field(1, Errors.WHITE, 60);
    new Ride(field, tracker).go(59);
    PoseEstimate pose = tracker.estimate(field.host(59)).orElseThrow();
    GpsFix first =
        (GpsFix)
            field.measurements.stream()
                .filter(h -> h.antenna() >= 0)
                .findFirst()
                .orElseThrow()
                .reading();
    assertThat(pose.datum()).isEqualTo(first.position());
    assertThat(pose.frame()).isEqualTo("r/map");
    GeoPosition truth =
        new org.dfra.geometry.LocalFrame(Field.DATUM)
            .toGeo(
                new org.dfra.geometry.LocalPosition(field.at(59).east(), field.at(59).north(), 0));
    // Raw fixes with 0.6 m of noise each way are the worst of it, up to a second and 0.6 m old.
    assertThat(pose.position().groundDistance(truth)).isLessThan(4);
  }

  @ParameterizedTest
  @EnumSource
  void isOfTheTimeAskedFor(TrackerKind kind) {
    PoseTracker tracker = kind.create(TrackerSettings.DEFAULT, "r/map", Field.DATUM);
    Field field = new Field(1, Errors.WHITE, 60);
    new Ride(field, tracker).go(50);
    assertThat(tracker.estimate(field.host(50.05)).orElseThrow().measured())
        .isEqualTo(field.host(50.05));
  }

  @ParameterizedTest
  @EnumSource
  void aRepeatedFixChangesNothing(TrackerKind kind) {
    Field field = new Field(1, Errors.WHITE, 60);
    PoseTracker once = kind.create(TrackerSettings.DEFAULT, "r/map", Field.DATUM);
    PoseTracker twice = kind.create(TrackerSettings.DEFAULT, "r/map", Field.DATUM);
    new Ride(field, once).go(59);
    Ride again = new Ride(field, twice);
    for (Field.Measurement received : field.measurements) {
      if (received.at() <= 59) {
        again.give(received);
        again.give(received);
      }
    }
    PoseEstimate expected = once.estimate(field.host(59)).orElseThrow();
    assertThat(twice.estimate(field.host(59))).contains(expected);
  }

  /** Otherwise it would take the rotation for the gyro's bias, with great certainty. */
  @ParameterizedTest
  @EnumSource
  void doesNotLearnTheGyrosErrorWhileItIsTurnedByHand(TrackerKind kind) {
    PoseTracker tracker = kind.create(TrackerTable.settings(0), "r/map", Field.DATUM);
    Field field = new Field(1, Errors.WHITE, 120);
    for (int i = -1000; i < 0; i++) {
      Instant time = field.host(i / 100.0);
      tracker.addMeasurement(new AngularRate(time, "r/gyro", 0.25));
      if (i % 10 == 0) {
        tracker.addMeasurement(new Odometry(time, "r/odom", "r/base", 0, 0, 0, 0, 0));
      }
    }
    Ride ride = new Ride(field, tracker).go(60).compare(60, 120);
    assertThat(ride.missing()).isZero();
    assertThat(ride.rms()).isLessThan(1.5);
  }

  @ParameterizedTest
  @EnumSource
  void neitherThrowsNorStaysConfusedByNonsense(TrackerKind kind) {
    long seed = Long.getLong("dfra.seed", new Random().nextLong());
    Random random = new Random(seed);
    for (int round = 0; round < 5; round++) {
      String what = "-Ddfra.seed=" + seed + ", round " + round;
      PoseTracker tracker = kind.create(TrackerTable.settings(0), "r/map", Field.DATUM);
      for (int i = 0; i < 4000; i++) {
        int at = i;
        assertThatCode(() -> nonsense(tracker, random, at)).as(what).doesNotThrowAnyException();
      }
      // The sensors are right again, and so is the tracker. Its clock starts again.
      Field field = new Field(round, Errors.WHITE, 240);
      Ride ride = new Ride(field, tracker);
      ride.go(180).compare(180, 240);
      assertThat(ride.missing()).as(what).isZero();
      assertThat(ride.rms()).as(what).isLessThan(1.5);
    }
  }

  private static void nonsense(PoseTracker tracker, Random random, int i) {
    Instant time = random.nextInt(10) == 0 ? moment(random) : Field.START.plusMillis(50L * i);
    switch (random.nextInt(4)) {
      case 0 -> {
        double x = odd(random);
        double y = odd(random);
        tracker.addMeasurement(
            new Odometry(time, "o", "b", x, y, odd(random), odd(random), odd(random)));
      }
      case 1 -> tracker.addMeasurement(new AngularRate(time, "g", odd(random)));
      case 2 -> {
        double latitude = 48 + random.nextGaussian() * (random.nextInt(5) == 0 ? 10 : 1e-3);
        GeoPosition position =
            new GeoPosition(
                Math.min(90, latitude), // which the far ones, very seldom, are beyond
                random.nextDouble() * 360 - 180,
                odd(random));
        double dilution = random.nextInt(5) == 0 ? Double.NaN : odd(random);
        GpsFix fix =
            new GpsFix(
                GpsFix.Mode.values()[1 + random.nextInt(3)],
                position,
                random.nextInt(10) == 0 ? moment(random) : time.minusMillis(200),
                random.nextInt(9) == 0 ? Double.POSITIVE_INFINITY : Math.abs(odd(random)),
                random.nextDouble() * 360,
                dilution,
                -3,
                99);
        Transform antenna = Transform.translation(odd(random), odd(random), odd(random));
        tracker.addMeasurement(fix, "gps_" + random.nextInt(6), antenna, time);
      }
      default ->
          tracker
              .estimate(time)
              .ifPresent(
                  pose -> {
                    // A record refuses what is not finite, but not these.
                    assertThat(pose.positionSigma()).isFinite();
                    assertThat(pose.yawSigma()).isFinite();
                    assertThat(pose.yaw()).isBetween(-Math.PI, Math.PI);
                  });
    }
  }

  private static Instant moment(Random random) {
    Instant moment = MOMENTS[random.nextInt(MOMENTS.length)];
    return moment.isBefore(Instant.EPOCH) ? Instant.MIN.plusSeconds(9) : moment;
  }

  private static double odd(Random random) {
    return random.nextInt(3) == 0
        ? ODD[random.nextInt(ODD.length)]
        : random.nextGaussian() * (random.nextBoolean() ? 0.1 : 10);
  }
}
