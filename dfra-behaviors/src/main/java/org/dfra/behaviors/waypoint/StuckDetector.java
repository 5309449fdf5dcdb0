package org.dfra.behaviors.waypoint;

import java.util.ArrayDeque;
import java.util.Deque;
import org.dfra.flow.perceptual.HeadingPercept;

/**
 * Notices that a robot that should move does not: it has stayed within a small circle for a while,
 * and has not turned either. Or that it moves and comes no nearer. Confined to one thread.
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
  private final Deque<ProgressSample> been = new ArrayDeque<>(); // the oldest first
  private double nearest = Double.POSITIVE_INFINITY;
  private long nearestNanos;

  /**
   * @param stuckTimeout seconds in one place after which a robot is stuck
   * @param noProgressTimeout seconds after which it is, having come no nearer
   */
  StuckDetector(double stuckTimeout, double noProgressTimeout) {
    this.standing = Math.round(stuckTimeout * 1e9);
    this.nowhere = Math.round(noProgressTimeout * 1e9);
  }

  /** Begins anew. */
  void reset() {
    been.clear();
    nearest = Double.POSITIVE_INFINITY;
  }

  /** Where the robot is now; whether it is stuck there. */
  boolean isStuck(long nanos, HeadingPercept now) {
    if (!been.isEmpty() && nanos - been.getLast().nanos() > standing / 2) {
      reset(); // what happened meanwhile was not watched
    }
    ProgressSample here =
        new ProgressSample(nanos, now.alongTrack(), now.crossTrack(), now.headingError());
    been.addLast(here);
    if (now.distance() < nearest - NEARER || been.size() == 1) {
      nearest = now.distance();
      nearestNanos = nanos;
    }
    boolean covered = false; // whether what is remembered is long enough
    while (nanos - been.getFirst().nanos() > standing) {
      been.removeFirst();
      covered = true;
    }
    return (covered && been.stream().allMatch(there -> isNear(there, here)))
        || nanos - nearestNanos > nowhere;
  }

  private static boolean isNear(ProgressSample there, ProgressSample here) {
    double way =
        Math.hypot(there.alongTrack() - here.alongTrack(), there.crossTrack() - here.crossTrack());
    double turn = Math.IEEEremainder(there.headingError() - here.headingError(), 2 * Math.PI);
    return way < CIRCLE && Math.abs(turn) < TURN;
  }
}
