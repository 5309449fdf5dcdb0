package org.dfra.behaviors.perceptual.pose;

import java.time.Instant;
import java.util.Optional;
import java.util.function.Predicate;
import org.dfra.flow.perceptual.PoseEstimate;
import org.dfra.flow.sensor.AngularRate;
import org.dfra.flow.sensor.GpsFix;
import org.dfra.flow.sensor.Odometry;

/** Gives a tracker a field's measurements, and compares its estimates with the truth. */
final class Ride {

  private final Field field;
  private final PoseTracker tracker;
  private Predicate<Field.Measurement> passes = received -> true;
  private double[] shift = new double[3];
  private long set;
  private int next;
  private int count;
  private int missing;
  private double square;
  private double yawSquare;
  private double nees;
  private double worst;
  private double worstYaw;

  Ride(Field field, PoseTracker tracker) {
    this.field = field;
    this.tracker = tracker;
  }

  /** How far the estimate is from the truth at a time, metres; it must be there. */
  double off(double t) {
    PoseEstimate estimate = tracker.estimate(host(t)).orElseThrow();
    Field.Truth truth = field.at(t);
    return Math.hypot(estimate.east() - truth.east(), estimate.north() - truth.north());
  }

  /** The odometry starts at another pose from now on: metres and radians are added. */
  void shiftOdometry(double x, double y, double yaw) {
    shift = new double[] {x, y, yaw};
  }

  /** Sets the robot's clock by so many seconds, + is ahead, from now on. */
  void setClock(double seconds) {
    set = Math.round(seconds * 1e9);
  }

  private Instant host(double t) {
    return field.host(t).plusNanos(set);
  }

  private Odometry shifted(Odometry o) {
    double cos = Math.cos(shift[2]);
    double sin = Math.sin(shift[2]);
    return new Odometry(
        o.measured().plusNanos(set),
        o.frame(),
        o.childFrame(),
        shift[0] + cos * o.x() - sin * o.y(),
        shift[1] + sin * o.x() + cos * o.y(),
        o.yaw() + shift[2],
        o.speed(),
        o.yawRate());
  }

  /** These measurements are lost from now on. */
  void without(Predicate<Field.Measurement> lost) {
    passes = lost.negate();
  }

  /** Goes on until a time, seconds from the beginning, without comparing. */
  Ride go(double until) {
    while (next < field.measurements.size() && field.measurements.get(next).at() <= until) {
      Field.Measurement received = field.measurements.get(next);
      if (passes.test(received)) {
        give(received);
      }
      next++;
    }
    return this;
  }

  void give(Field.Measurement received) {
    if (received.reading() instanceof Odometry odometry) {
      tracker.addMeasurement(shifted(odometry));
    } else if (received.reading() instanceof AngularRate rate) {
      tracker.addMeasurement(
          new AngularRate(rate.measured().plusNanos(set), rate.frame(), rate.rate()));
    } else {
      tracker.addMeasurement(
          (GpsFix) received.reading(),
          Field.SOURCES.get(received.antenna()),
          Field.ANTENNAS.get(received.antenna()),
          host(received.at()));
    }
  }

  /** Goes on until a time and compares five times a second, from now on only. */
  Ride compare(double from, double until) {
    count = 0;
    missing = 0;
    square = 0;
    yawSquare = 0;
    nees = 0;
    worst = 0;
    worstYaw = 0;
    int steps = (int) Math.round((until - from) * 5);
    for (int i = 1; i <= steps; i++) {
      double t = from + i / 5.0;
      go(t);
      compareAt(t);
    }
    return this;
  }

  private void compareAt(double t) {
    Optional<PoseEstimate> estimate = tracker.estimate(host(t));
    if (estimate.isEmpty()) {
      missing++;
      return;
    }
    Field.Truth truth = field.at(t);
    double e = estimate.get().east() - truth.east();
    double n = estimate.get().north() - truth.north();
    double yaw = Math.IEEEremainder(estimate.get().yaw() - truth.yaw(), 2 * Math.PI);
    count++;
    square += e * e + n * n;
    worst = Math.max(worst, Math.hypot(e, n));
    yawSquare += yaw * yaw;
    worstYaw = Math.max(worstYaw, Math.abs(yaw));
    if (tracker instanceof KalmanTracker kalman && kalman.belief().isPresent()) {
      Belief belief = kalman.belief().get();
      double a = belief.covariance.get(0, 0);
      double b = belief.covariance.get(0, 1);
      double d = belief.covariance.get(1, 1);
      nees += (d * e * e - 2 * b * e * n + a * n * n) / (a * d - b * b);
    }
  }

  int missing() {
    return missing;
  }

  /** Root mean square of the distance to the truth, metres. */
  double rms() {
    return Math.sqrt(square / count);
  }

  double worst() {
    return worst;
  }

  /** Root mean square of the yaw's error, radians. */
  double yawRms() {
    return Math.sqrt(yawSquare / count);
  }

  double worstYaw() {
    return worstYaw;
  }

  /** Mean of the squared position error weighted by its covariance; 2 is just right. */
  double nees() {
    return nees / count;
  }
}
