package org.dfra.behaviors.perceptual.pose;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.SplittableRandom;
import java.util.stream.LongStream;
import org.dfra.behaviors.perceptual.pose.Field.Errors;
import org.dfra.behaviors.perceptual.pose.Field.Measurement;
import org.dfra.flow.perceptual.PoseEstimate;
import org.dfra.flow.sensor.AngularRate;
import org.dfra.flow.sensor.GpsFix;
import org.dfra.flow.sensor.Odometry;
import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.MatrixFeatures_DDRM;
import org.ejml.dense.row.factory.DecompositionFactory_DDRM;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** {@code -Ddfra.full=true} takes rides of five seeds, otherwise of two. */
class KalmanTrackerTest {

  /** Far from the truth, metres: many times the 0.15 m that white noise leaves. */
  private static final double FAR = 1;

  static LongStream seeds() {
    return LongStream.rangeClosed(1, Boolean.getBoolean("dfra.full") ? 5 : 2);
  }

  private static KalmanTracker tracker() {
    return new KalmanTracker(TrackerTable.settings(0), "r/map", Field.DATUM, null);
  }

  private static boolean isFix(Measurement received) {
    return received.reading() instanceof GpsFix;
  }

  @ParameterizedTest
  @MethodSource("seeds")
  void goesOnWithOneReceiver(long seed) {
    Ride ride = new Ride(new Field(seed, Errors.WHITE, 300), tracker());
    ride.go(60).without(received -> received.antenna() == 0);
    ride.compare(60, 300);
    assertThat(ride.missing()).isZero();
    assertThat(ride.worst()).isLessThan(FAR);
  }

  @ParameterizedTest
  @MethodSource("seeds")
  void bridgesAMinuteWithoutFixes(long seed) {
    KalmanTracker tracker = tracker();
    Field field = new Field(seed, Errors.WHITE, 300);
    Ride ride = new Ride(field, tracker);
    ride.go(120);
    double before = tracker.estimate(field.host(120)).orElseThrow().positionSigma();
    ride.without(KalmanTrackerTest::isFix);
    ride.compare(120, 180);
    // 36 m of way: scale known to 1 %, yaw to 0.03 rad, both at three sigma.
    assertThat(ride.worst()).isLessThan(FAR + 3 * 36 * 0.03);
    PoseEstimate blind = tracker.estimate(field.host(180)).orElseThrow();
    assertThat(blind.positionSigma()).isGreaterThan(2 * before);
    assertThat(blind.fixAge()).isGreaterThan(java.time.Duration.ofSeconds(58));
    ride.without(received -> false);
    ride.go(200).compare(200, 300);
    assertThat(ride.worst()).isLessThan(FAR);
  }

  @ParameterizedTest
  @MethodSource("seeds")
  void leavesOutliersOut(long seed) {
    Field field = new Field(seed, Errors.WHITE, 300);
    KalmanTracker tracker = tracker();
    Ride ride = new Ride(field, tracker);
    ride.go(60);
    SplittableRandom random = new SplittableRandom(seed);
    for (int i = 60; i < 290; i++) {
      ride.go(i);
      if (random.nextInt(4) == 0) {
        // Between two good fixes, 50 m off anywhere.
        double at = i - 0.5;
        double way = random.nextDouble(2 * Math.PI);
        Field.Truth truth = field.at(at);
        double east = truth.east() + 50 * Math.cos(way);
        double north = truth.north() + 50 * Math.sin(way);
        ride.give(new Measurement(at + 0.2, field.fix(at, east, north, 0, 0), i % 2));
        assertThat(ride.off(at + 0.5)).as("at %s s", at).isLessThan(FAR);
      }
    }
  }

  @ParameterizedTest
  @MethodSource("seeds")
  void findsItselfWhenItWasCarriedAway(long seed) {
    KalmanTracker tracker = tracker();
    new Ride(new Field(seed, Errors.WHITE, 100), tracker).go(99);
    // Another place and direction; the wheels count from another place, the gyro has another bias.
    Ride there = new Ride(new Field(seed + 1000, Errors.WHITE, 300), tracker);
    there.without(received -> true);
    there.go(99).without(received -> false);
    there.go(160).compare(160, 300);
    assertThat(there.missing()).isZero();
    assertThat(there.worst()).isLessThan(FAR);
    assertThat(there.worstYaw()).isLessThan(0.3);
  }

  @ParameterizedTest
  @MethodSource("seeds")
  void ignoresThatTheOdometryRestarts(long seed) {
    Field field = new Field(seed, Errors.WHITE, 300);
    KalmanTracker tracker = tracker();
    Ride ride = new Ride(field, tracker).go(100);
    ride.shiftOdometry(-40, 17, 1.3);
    ride.compare(100, 300);
    assertThat(ride.worst()).isLessThan(FAR);
  }

  @ParameterizedTest
  @MethodSource("seeds")
  void survivesAClockThatIsSet(long seed) {
    Field field = new Field(seed, Errors.WHITE, 400);
    for (double set : new double[] {-3600, 3600, -7}) {
      KalmanTracker tracker = tracker();
      Ride ride = new Ride(field, tracker).go(100);
      ride.setClock(set);
      ride.go(200).compare(200, 400);
      assertThat(ride.missing()).as("set by %s s", set).isZero();
      assertThat(ride.worst()).as("set by %s s", set).isLessThan(FAR);
    }
  }

  @Test
  void saysThatItsYawIsUnknownUntilItMoves() {
    Field field = new Field(1, Errors.WHITE, 60);
    KalmanTracker tracker = tracker();
    Ride ride = new Ride(field, tracker).go(9);
    PoseEstimate standing = tracker.estimate(field.host(9)).orElseThrow();
    assertThat(standing.yawSigma()).isGreaterThan(1);
    assertThat(ride.off(9)).isLessThan(FAR);
    ride.go(20);
    PoseEstimate moving = tracker.estimate(field.host(20)).orElseThrow();
    assertThat(moving.yawSigma()).isLessThan(0.1);
    assertThat(Math.IEEEremainder(moving.yaw() - field.at(20).yaw(), 2 * Math.PI))
        .isBetween(-0.3, 0.3);
  }

  @Test
  void takesAYawThatIsKnownBefore() {
    Field field = new Field(1, Errors.WHITE, 60);
    double yaw = field.at(0).yaw();
    KalmanTracker tracker =
        new KalmanTracker(
            TrackerTable.settings(0),
            "r/map",
            Field.DATUM,
            new KalmanTracker.InitialYaw(yaw + 0.05, 0.1));
    new Ride(field, tracker).go(9);
    PoseEstimate standing = tracker.estimate(field.host(9)).orElseThrow();
    assertThat(Math.IEEEremainder(standing.yaw() - yaw, 2 * Math.PI)).isBetween(-0.1, 0.2);
    assertThat(standing.yawSigma()).isBetween(0.02, 0.12);
  }

  @Test
  void knowsWhichWayItGoesBackwards() {
    // Facing east, going west; no noise.
    KalmanTracker tracker = tracker();
    Field field = new Field(1, Errors.WHITE, 1);
    for (int i = 0; i <= 200; i++) {
      double t = i / 10.0;
      double x = -0.5 * t;
      tracker.addMeasurement(new Odometry(field.host(t), "r/odom", "r/base", x, 0, 0, -0.5, 0));
      tracker.addMeasurement(new AngularRate(field.host(t), "r/gyro", 0));
      if (i % 10 == 5) {
        double then = t - 0.3;
        GpsFix fix = field.fix(then, -0.5 * then + 0.3, 0, -0.5, 0);
        tracker.addMeasurement(fix, "gps_front", Field.ANTENNAS.get(0), field.host(then + 0.16));
      }
    }
    PoseEstimate pose = tracker.estimate(field.host(20)).orElseThrow();
    assertThat(pose.yaw()).isBetween(-0.05, 0.05);
    assertThat(pose.east()).isBetween(-10.1, -9.9);
    assertThat(pose.speed()).isBetween(-0.52, -0.48);
  }

  @Test
  void learnsTheGyrosBiasStanding() {
    Field field = new Field(1, Errors.WHITE, 1);
    KalmanTracker tracker =
        new KalmanTracker(
            TrackerTable.settings(0), "r/map", Field.DATUM, new KalmanTracker.InitialYaw(0, 0.1));
    for (int i = 0; i <= 600; i++) {
      double t = i / 10.0;
      tracker.addMeasurement(new AngularRate(field.host(t), "r/gyro", 0.02));
      tracker.addMeasurement(new Odometry(field.host(t), "r/odom", "r/base", 0, 0, 0, 0, 0));
      if (i == 100) {
        tracker.addMeasurement(
            field.fix(9.8, 0.3, 0, 0, 0), "g", Field.ANTENNAS.get(0), field.host(9.96));
      }
    }
    PoseEstimate pose = tracker.estimate(field.host(60)).orElseThrow();
    assertThat(pose.yawRate()).isBetween(-1e-3, 1e-3);
    assertThat(pose.yaw()).isBetween(-0.01, 0.01);
  }

  @Test
  void reportsHowFarTheClockIsAhead() {
    Field field = new Field(1, Errors.WHITE, 60);
    KalmanTracker tracker = tracker();
    new Ride(field, tracker).go(59);
    double offset = tracker.estimate(field.host(59)).orElseThrow().clockOffset().seconds();
    // Ahead by 3.7 s; the least latency is 0.16 s, and of 64 fixes one comes nearly as soon.
    assertThat(offset).isBetween(3.86, 3.87);
  }

  @ParameterizedTest
  @MethodSource("seeds")
  void keepsItsCovarianceSymmetricAndPositive(long seed) {
    Field field = new Field(seed, Errors.WHITE.withBias(1.5), 300);
    KalmanTracker tracker = new KalmanTracker(TrackerSettings.DEFAULT, "r/map", Field.DATUM, null);
    Ride ride = new Ride(field, tracker);
    int checked = 0;
    for (int t = 1; t < 300; t++) {
      ride.go(t);
      if (tracker.belief().isPresent()) {
        DMatrixRMaj covariance = tracker.belief().get().covariance.copy();
        assertThat(MatrixFeatures_DDRM.isSymmetric(covariance, 0)).as("at %s s", t).isTrue();
        assertThat(DecompositionFactory_DDRM.chol(Belief.SIZE, true).decompose(covariance))
            .as("positive at %s s", t)
            .isTrue();
        checked++;
      }
    }
    assertThat(checked).isGreaterThan(250);
  }
}
