package org.dfra.behaviors.waypoint;

import java.util.ArrayDeque;
import java.util.Deque;
import org.dfra.flow.perceptual.HeadingPercept;

/**
 * Detects that a commanded robot does not move: it has stayed within a small circle for a while
 * without rotation. Or that it moves without progress. Confined to one thread.
 *
 * @see RecoveryManeuver
 */
final class StuckDetector {

  private static final double CIRCLE = 0.3; // metres
  private static final double TURN = Math.toRadians(35);
  private static final double NEARER = 0.5; // metres

  private record ProgressSample(
      long nanos, double alongTrack, double crossTrack, double headingError) {}

  private final long standing; // nanoseconds
  private final long nowhere; // nanoseconds
  private final Deque<ProgressSample> sample = new ArrayDeque<>(); // the oldest first
  private double nearest = Double.POSITIVE_INFINITY;
  private long nearestNanos;

  /**
   * @param stuckTimeout seconds without motion after which a robot is stuck
   * @param noProgressTimeout seconds without progress after which it is
   */
  StuckDetector(double stuckTimeout, double noProgressTimeout) {
    this.standing = Math.round(stuckTimeout * 1e9);
    this.nowhere = Math.round(noProgressTimeout * 1e9);
  }

  /** Restarts. */
  void reset() {
    sample.clear();
    nearest = Double.POSITIVE_INFINITY;
  }

  /** Adds the robot's current pose; returns whether it is stuck. */
  boolean isStuck(long nanos, HeadingPercept now) {
    if (!sample.isEmpty() && nanos - sample.getLast().nanos() > standing / 2) {
      reset(); // the interval was not monitored
    }
    ProgressSample here =
        new ProgressSample(nanos, now.alongTrack(), now.crossTrack(), now.headingError());
    sample.addLast(here);
    if (now.distance() < nearest - NEARER || sample.size() == 1) {
      nearest = now.distance();
      nearestNanos = nanos;
    }
    boolean covered = false; // whether the samples span the timeout
    while (nanos - sample.getFirst().nanos() > standing) {
      sample.removeFirst();
      covered = true;
    }
    return (covered && sample.stream().allMatch(there -> isNear(there, here)))
        || nanos - nearestNanos > nowhere;
  }

  private static boolean isNear(ProgressSample there, ProgressSample here) {
    double way =
        Math.hypot(there.alongTrack() - here.alongTrack(), there.crossTrack() - here.crossTrack());
    double turn = Math.IEEEremainder(there.headingError() - here.headingError(), 2 * Math.PI);
    return way < CIRCLE && Math.abs(turn) < TURN;
  }
}
