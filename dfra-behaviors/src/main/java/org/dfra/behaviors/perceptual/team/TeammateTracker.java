package org.dfra.behaviors.perceptual.team;

import java.time.Instant;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Iterator;
import java.util.Locale;
import java.util.Optional;
import org.dfra.flow.perceptual.PoseEstimate;
import org.dfra.flow.perceptual.Teammate;
import org.dfra.geometry.LocalFrame;
import org.dfra.geometry.LocalPosition;
import org.dfra.time.ClockOffset;
import org.jspecify.annotations.Nullable;

/**
 * Tracks one other robot by its received poses. Confined to one thread at a time.
 *
 * <pre>
 *   IN_REACH ---no pose for the timeout---&gt; OUT_OF_REACH
 *      ^---------a pose is received-------------'
 * </pre>
 *
 * It reports both transitions in a sentence.
 */
final class TeammateTracker {

  private static final int MAX_POSES = 64; // poses: some six seconds

  private enum State {
    /** Poses are received. */
    IN_REACH,
    /** No pose was received for the timeout. */
    OUT_OF_REACH
  }

  private final String robot;
  private final Deque<PoseEstimate> poses = new ArrayDeque<>(); // by its own clock, the newest last
  private State state = State.IN_REACH;
  private long receivedNanos;
  private Instant received = Instant.MIN;
  private long sequence = -1; // of the last pose received
  private long missed;
  private @Nullable ClockOffset clock;
  private Teammate.@Nullable RelativePosition lastPosition;

  TeammateTracker(String robot) {
    this.robot = robot;
  }

  /**
   * Adds a received pose.
   *
   * @param number of the delivery, consecutive
   * @param now by the own robot's clock
   * @param nanos steady time
   * @return the message to report, if any
   */
  Optional<String> receive(PoseEstimate pose, long number, Instant now, long nanos, long timeout) {
    long gap = sequence < 0 ? 0 : Math.max(0, number - sequence - 1);
    boolean wasSilent = sequence >= 0 && nanos - receivedNanos > timeout;
    double seconds = (nanos - receivedNanos) / 1e9;
    missed += gap;
    sequence = number;
    received = now;
    receivedNanos = nanos;
    state = State.IN_REACH;
    @Nullable PoseEstimate last = poses.peekLast();
    if (last != null && !pose.measured().isAfter(last.measured())) {
      poses.clear(); // its clock was set
    }
    poses.addLast(pose);
    if (poses.size() > MAX_POSES) {
      poses.removeFirst();
    }
    return wasSilent
        ? Optional.of(
            String.format(
                Locale.ROOT,
                "%s was out of reach for %.0f s, %d %s missed",
                robot,
                seconds,
                gap,
                gap == 1 ? "reading" : "readings"))
        : Optional.empty();
  }

  /** Checks for a timeout; reports it once. */
  Optional<String> checkSilence(long nanos, long timeout) {
    if (state == State.OUT_OF_REACH || nanos - receivedNanos <= timeout) {
      return Optional.empty();
    }
    state = State.OUT_OF_REACH;
    return Optional.of(
        String.format(
            Locale.ROOT,
            "%s is out of reach: no message from it for %.0f s",
            robot,
            (nanos - receivedNanos) / 1e9));
  }

  /** Its state, by the newest of its poses for whose instant the own position is known. */
  Teammate relativeTo(OwnPoseBuffer own) {
    @Nullable PoseEstimate here = own.newest();
    @Nullable PoseEstimate there = poses.peekLast();
    @Nullable ClockOffset mine = here == null ? null : here.clockOffset();
    @Nullable ClockOffset its = there == null ? null : there.clockOffset();
    clock = mine == null || its == null ? null : its.relativeTo(mine);
    if (clock == null) {
      lastPosition = null;
    } else {
      Teammate.@Nullable RelativePosition newest = newest(own, clock);
      lastPosition = newest == null ? lastPosition : newest;
    }
    return new Teammate(robot, received, state == State.OUT_OF_REACH, missed, clock, lastPosition);
  }

  private Teammate.@Nullable RelativePosition newest(OwnPoseBuffer own, ClockOffset offset) {
    for (Iterator<PoseEstimate> all = poses.descendingIterator(); all.hasNext(); ) {
      PoseEstimate there = all.next();
      Instant at = offset.toOtherClock(there.measured());
      OwnPoseBuffer.@Nullable InterpolatedPosition here = own.at(at);
      if (here != null) {
        return near(at, here, there, offset);
      }
    }
    return null;
  }

  private static Teammate.RelativePosition near(
      Instant at, OwnPoseBuffer.InterpolatedPosition here, PoseEstimate there, ClockOffset offset) {
    PoseEstimate own = here.nearest();
    LocalPosition place = new LocalFrame(own.datum()).toLocal(there.position());
    double way = (Math.abs(own.speed()) + Math.abs(there.speed())) * offset.uncertaintySeconds();
    return new Teammate.RelativePosition(
        at,
        place.east() - here.east(),
        place.north() - here.north(),
        Math.hypot(own.positionSigma(), there.positionSigma()) + way);
  }
}
