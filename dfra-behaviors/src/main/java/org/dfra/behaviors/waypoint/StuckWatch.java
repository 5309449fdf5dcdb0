package org.dfra.behaviors.waypoint;

import java.util.ArrayDeque;
import java.util.Deque;
import org.dfra.flow.perceptual.HeadingPercept;

/**
 * Notices that a robot that should move does not: it has stayed within a small circle for a while,
 * and has not turned either. Or that it moves and comes no nearer. Confined to one thread.
 *
 * @see Recovery
 */
final class StuckWatch {

  private static final double CIRCLE = 0.3; // metres
  private static final double TURN = Math.toRadians(35);
  private static final double NEARER = 0.5; // metres

  private record Been(long nanos, double along, double crossTrack, double headingError) {}

  private final long standing; // nanoseconds
  private final long nowhere; // nanoseconds
  private final Deque<Been> been = new ArrayDeque<>(); // the oldest first
  private double nearest = Double.POSITIVE_INFINITY;
  private long nearestNanos;

  /**
   * @param standing seconds in one place after which a robot is stuck
   * @param nowhere seconds after which it is, having come no nearer
   */
  StuckWatch(double standing, double nowhere) {
    this.standing = Math.round(standing * 1e9);
    this.nowhere = Math.round(nowhere * 1e9);
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
    Been here = new Been(nanos, now.along(), now.crossTrack(), now.headingError());
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

  private static boolean isNear(Been there, Been here) {
    double way = Math.hypot(there.along() - here.along(), there.crossTrack() - here.crossTrack());
    double turn = Math.IEEEremainder(there.headingError() - here.headingError(), 2 * Math.PI);
    return way < CIRCLE && Math.abs(turn) < TURN;
  }
}
