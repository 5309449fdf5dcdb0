package org.dfra.drivers.drive.rflex;

import org.dfra.drivers.drive.rflex.RflexMessage.Axis;
import org.dfra.drivers.drive.rflex.RflexMessage.MotorReport;

/**
 * Adds up where wheels have carried the robot from what the controller counts. Confined to one
 * thread; reads no clock.
 *
 * <p>Each axis is counted by itself, and both are put together when both have been told: the robot
 * is taken to have gone along an arc in between. A report that was lost is made good by the next.
 *
 * <p>The controller's counts wrap around at 32 bits. Where it was switched off and on they begin
 * anew, which is no motion: its clock has gone back, or the count went further than wheels can in
 * {@value #LONGEST_GAP} s, or the link was away and the count is 0 after it.
 */
final class WheelOdometer {

  /** Seconds; the link is opened anew and wheels stand long before. */
  private static final double LONGEST_GAP = 3;

  /** One axis. */
  private static final class Count {
    final double perUnit;
    final double longest; // metres or radians from one report to the next
    boolean known;
    boolean afterGap;
    boolean fresh; // told since both were put together
    int position;
    long timestamp;
    double moved; // metres or radians since both were put together
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
   * @param maxSpeed metres per second that wheels can go
   * @param maxYawRate radians per second likewise
   */
  WheelOdometer(double countsPerMetre, double countsPerRadian, double maxSpeed, double maxYawRate) {
    this.along = new Count(countsPerMetre, maxSpeed);
    this.about = new Count(countsPerRadian, maxYawRate);
  }

  /** The link was away: nobody knows what happened meanwhile. */
  void linkInterrupted() {
    along.afterGap = true;
    about.afterGap = true;
  }

  /**
   * Takes a report.
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
    // The chord of an arc, which is the arc itself where it is straight.
    double chord = half == 0 ? along.moved : along.moved * Math.sin(half) / half;
    x += chord * Math.cos(yaw + half);
    y += chord * Math.sin(yaw + half);
    yaw += about.moved;
    along.moved = 0;
    about.moved = 0;
    along.fresh = false;
    about.fresh = false;
  }

  /** Metres forward of the beginning. */
  double x() {
    return x;
  }

  /** Metres to the left of the beginning. */
  double y() {
    return y;
  }

  /** Radians to the left since the beginning, not wrapped. */
  double yaw() {
    return yaw;
  }

  /** Metres per second, forward is +, as last told. */
  double speed() {
    return along.speed;
  }

  /** Radians per second, to the left is +, as last told. */
  double yawRate() {
    return about.speed;
  }

  /** How often an axis began to count anew. */
  long restarts() {
    return restarts;
  }
}
