package org.dfra.behaviors.waypoint;

import java.time.Duration;
import java.time.Instant;
import org.dfra.flow.effector.DriveCommand.Velocity;
import org.dfra.flow.perceptual.Clearance;

/**
 * Takes off a clearance what this robot and another one can have come nearer to each other since it
 * was measured, and will until the velocity that it leads to is replaced.
 *
 * <pre>
 *   late   = age of the clearance + length of the last cycle - 0.2 s     0 to 1 s
 *   ahead  : (own speed + peer's speed) * late is taken off
 *   beside : peer's speed * late
 * </pre>
 *
 * <p>The rules keep their distances, which hold the braking distance (0.25 m from 0.7 m/s with 1
 * m/s²), for a clearance at most 0.1 s old in cycles of 0.1 s. Nothing is taken off then. On a slow
 * or busy computer both come late, and the more so where the robots' time goes faster than real
 * time: a delay of 0.1 s is 0.25 s of a demonstration that is played 2.5 times as fast. Two robots
 * at 0.7 m/s come 0.35 m nearer in that time, which the rules' distances do not hold.
 *
 * <p>Own speed is the highest that was commanded within the last second: a robot that has just been
 * stopped still has a clearance from before.
 *
 * <p>The margin makes things look nearer; it never stops a robot by itself. So two robots that meet
 * pass each other by the rules, as they would if they were that much nearer, and the margin ends
 * with the delay. A velocity counts for 0.3 s at most, since wheels without a command stop then.
 *
 * <p>Confined to the behaviour's cycles.
 */
final class ClearanceMargin {

  /** Of age and cycle together, which the rules allow for, seconds. */
  static final double ALLOWED_LATENCY = 0.2;

  /** Beyond it nothing more is taken off, so that a clock that leaps does not hold a robot. */
  static final double MAX_LATENCY = 1;

  private static final double CYCLE = 0.1; // seconds, where there was none before
  private static final double LONGEST_CYCLE = 0.3; // seconds, the wheels' command timeout

  private final double peerSpeed;
  private double cycle = CYCLE; // seconds
  private boolean isRunning; // whether there was a cycle since the last reset
  private long last; // nanoseconds, of that cycle
  private double fastest; // metres per second
  private long fastestAt; // nanoseconds

  /**
   * @param peerSpeed the highest of other robots, metres per second, not negative
   */
  ClearanceMargin(double peerSpeed) {
    this.peerSpeed = peerSpeed;
  }

  /**
   * What is left of a clearance. Once in a cycle.
   *
   * @param now by the clock that says when it was measured
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

  /** The wheels were commanded so. */
  void recordCommand(Velocity velocity, long nanos) {
    double speed = Math.max(0, velocity.speed());
    if (speed >= fastest || !isRecent(nanos)) {
      fastest = speed;
      fastestAt = nanos;
    }
  }

  /** The cycles end; the time until the next begins is none of theirs. */
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
