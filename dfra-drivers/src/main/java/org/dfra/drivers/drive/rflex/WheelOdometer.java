package org.dfra.drivers.drive.rflex;

import org.dfra.drivers.drive.rflex.RflexMessage.Axis;
import org.dfra.drivers.drive.rflex.RflexMessage.MotorReport;

/**
 * Integrates the robot's pose from the controller's counts (dead reckoning). Confined to one
 * thread; reads no clock.
 *
 * <p>Each axis is counted separately. When both have been reported, their motions are combined into
 * an arc. The next report compensates for a lost one.
 *
 * <p>The controller's counts wrap around at 32 bits. They restart when the controller is switched
 * off and on, which is not a motion. A restart is detected when its clock goes back, when a count
 * changes more than the wheels can move in {@value #LONGEST_GAP} s, or when a count is 0 after the
 * link was interrupted.
 */
final class WheelOdometer {

  /** Seconds; the link is reopened and the wheels stop long before that. */
  private static final double LONGEST_GAP = 3;

  /** One axis. */
  private static final class Count {
    final double perUnit;
    final double longest; // metres or radians from one report to the next
    boolean known;
    boolean afterGap;
    boolean fresh; // reported since both were combined
    int position;
    long timestamp;
    double moved; // metres or radians since both were combined
    double speed;

    Count(double perUnit, double fastest) {
      this.perUnit = perUnit;
      this.longest = fastest * LONGEST_GAP;
    }

    boolean take(MotorReport report) {
      boolean restarted = known && isRestart(report);
      if (known && !restarted) {
        moved += (report.position() - position) / perUnit; // the difference wraps around too
      }
      known = true;
      afterGap = false;
      fresh = true;
      position = report.position();
      timestamp = report.timestamp();
      speed = report.velocity() / perUnit;
      return restarted;
    }

    private boolean isRestart(MotorReport report) {
      return (int) (report.timestamp() - timestamp) < 0
          || Math.abs((report.position() - position) / perUnit) > longest
          || (afterGap && report.position() == 0 && position != 0);
    }
  }

  private final Count along;
  private final Count about;
  private double x;
  private double y;
  private double yaw;
  private long restarts;

  /**
   * @param countsPerMetre counts for a metre, negative where the controller counts backwards
   * @param countsPerRadian counts for a radian, negative where it counts to the right
   * @param maxSpeed maximum speed of the wheels, metres per second
   * @param maxYawRate maximum yaw rate, radians per second
   */
  WheelOdometer(double countsPerMetre, double countsPerRadian, double maxSpeed, double maxYawRate) {
    this.along = new Count(countsPerMetre, maxSpeed);
    this.about = new Count(countsPerRadian, maxYawRate);
  }

  /** The link was interrupted: reports may be missing. */
  void linkInterrupted() {
    along.afterGap = true;
    about.afterGap = true;
  }

  /**
   * Processes a report.
   *
   * @return whether there is a new pose
   */
  boolean update(MotorReport report) {
    Count count = report.axis() == Axis.TRANSLATION ? along : about;
    boolean missed = count.fresh; // the other axis' report
    if (missed) {
      join();
    }
    if (count.take(report)) {
      restarts++;
    }
    if (along.fresh && about.fresh) {
      join();
      return true;
    }
    return missed && along.known && about.known;
  }

  private void join() {
    double half = about.moved / 2;
    // The chord of the arc, which equals the arc where it is straight.
    double chord = half == 0 ? along.moved : along.moved * Math.sin(half) / half;
    x += chord * Math.cos(yaw + half);
    y += chord * Math.sin(yaw + half);
    yaw += about.moved;
    along.moved = 0;
    about.moved = 0;
    along.fresh = false;
    about.fresh = false;
  }

  /** Position along the initial x axis, metres. */
  double x() {
    return x;
  }

  /** Position along the initial y axis (left), metres. */
  double y() {
    return y;
  }

  /** Yaw since the beginning, radians, left is +, not wrapped. */
  double yaw() {
    return yaw;
  }

  /** Last reported speed, metres per second, forward is +. */
  double speed() {
    return along.speed;
  }

  /** Last reported yaw rate, radians per second, left is +. */
  double yawRate() {
    return about.speed;
  }

  /** How often an axis restarted its count. */
  long restarts() {
    return restarts;
  }
}
