package org.dfra.behaviors.waypoint;

import java.time.Duration;
import java.time.Instant;
import org.dfra.flow.effector.DriveCommand.Velocity;
import org.dfra.flow.perceptual.Clearance;

/**
 * Reduces a clearance by the distance that this robot and another one can have approached each
 * other since its measurement, and will until the resulting velocity is replaced.
 *
 * <pre>
 *   late   = age of the clearance + length of the last cycle - 0.2 s     0 to 1 s
 *   ahead : subtracts (own speed + peer's speed) * late
 *   beside : subtracts peer's speed * late
 * </pre>
 *
 * <p>The controller's safety distances include the braking distance (0.25 m from 0.7 m/s with 1
 * m/s²), for a clearance at most 0.1 s old and cycles of 0.1 s. Then nothing is subtracted. On a
 * slow or busy computer both are late, especially where the robots' time runs faster than real
 * time: a delay of 0.1 s is 0.25 s of a demonstration at 2.5 times real time. Two robots at 0.7 m/s
 * approach by 0.35 m in that time, which the controller's distances do not include.
 *
 * <p>Own speed is the highest command of the last second: a robot that has just stopped still has
 * an older clearance.
 *
 * <p>The margin makes objects appear nearer; it never stops a robot by itself. So two robots that
 * meet pass each other by the controller's rules, as if they were nearer by the margin, which ends
 * with the delay. A velocity counts for at most 0.3 s, the wheels' command timeout.
 *
 * <p>Confined to the behaviour's cycles.
 */
final class ClearanceMargin {

  /** Sum of age and cycle that the controller allows for, seconds. */
  static final double ALLOWED_LATENCY = 0.2;

  /** Maximum delay used, so that a clock jump does not block a robot. */
  static final double MAX_LATENCY = 1;

  private static final double CYCLE = 0.1; // seconds, without a previous cycle
  private static final double LONGEST_CYCLE = 0.3; // seconds, the wheels' command timeout

  private final double peerSpeed;
  private double cycle = CYCLE; // seconds
  private boolean isRunning; // whether there was a cycle since the last reset
  private long last; // nanoseconds, of that cycle
  private double fastest; // metres per second
  private long fastestAt; // nanoseconds

  /**
   * @param peerSpeed maximum speed of other robots, metres per second, not negative
   */
  ClearanceMargin(double peerSpeed) {
    this.peerSpeed = peerSpeed;
  }

  /**
   * The reduced clearance. Call it once per cycle.
   *
   * @param now by the clock of its timestamp
   * @param nanos the robot's monotonic time
   */
  Clearance reduced(Clearance measured, Instant now, long nanos) {
    if (isRunning) {
      cycle = Math.min(LONGEST_CYCLE, Math.max(0, seconds(nanos - last)));
    }
    isRunning = true;
    last = nanos;
    double age = Math.max(0, seconds(Duration.between(measured.measured(), now).toNanos()));
    double late = Math.max(0, Math.min(MAX_LATENCY, age + cycle - ALLOWED_LATENCY));
    double own = isRecent(nanos) ? fastest : 0;
    double ahead = (own + peerSpeed) * late;
    double beside = peerSpeed * late;
    return new Clearance(
        measured.measured(),
        measured.frame(),
        Math.max(0, measured.left() - beside),
        Math.max(0, measured.centre() - ahead),
        Math.max(0, measured.right() - beside));
  }

  /** Records a commanded velocity. */
  void recordCommand(Velocity velocity, long nanos) {
    double speed = Math.max(0, velocity.speed());
    if (speed >= fastest || !isRecent(nanos)) {
      fastest = speed;
      fastestAt = nanos;
    }
  }

  /** The cycles end; the time until the next start does not count. */
  void reset() {
    isRunning = false;
    cycle = CYCLE;
  }

  private boolean isRecent(long nanos) {
    return seconds(nanos - fastestAt) <= MAX_LATENCY;
  }

  private static double seconds(long nanos) {
    return nanos / 1e9;
  }
}
