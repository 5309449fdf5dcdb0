package org.dfra.behaviors.perceptual.team;

import java.time.Instant;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Iterator;
import java.util.Locale;
import java.util.Optional;
import org.dfra.flow.perceptual.PoseEstimate;
import org.dfra.flow.perceptual.TeamMate;
import org.dfra.geometry.LocalFrame;
import org.dfra.geometry.LocalPosition;
import org.dfra.time.ClockOffset;
import org.jspecify.annotations.Nullable;

/**
 * What was heard of one other robot. Confined to one thread at a time.
 *
 * <pre>
 *   IN_REACH --silent for too long--&gt; OUT_OF_REACH
 *      ^---------a pose is heard----------'
 * </pre>
 *
 * Both ways it says so in a sentence.
 */
final class MateTrail {

  private static final int KEPT = 64; // poses: some six seconds

  private enum State {
    /** Its poses come. */
    IN_REACH,
    /** Waits for the next. */
    OUT_OF_REACH
  }

  private final String robot;
  private final Deque<PoseEstimate> poses = new ArrayDeque<>(); // by its own clock, the newest last
  private State state = State.IN_REACH;
  private long heardNanos;
  private Instant heard = Instant.MIN;
  private long sequence = -1; // of the pose heard last
  private long missed;
  private @Nullable ClockOffset clock;
  private TeamMate.@Nullable Near near;

  MateTrail(String robot) {
    this.robot = robot;
  }

  /**
   * Takes a pose that it told.
   *
   * @param number of the delivery, counted without gap
   * @param now by the asker's clock
   * @param nanos steady time
   * @return what there is to say of it
   */
  Optional<String> take(PoseEstimate pose, long number, Instant now, long nanos, long longest) {
    long gap = sequence < 0 ? 0 : Math.max(0, number - sequence - 1);
    boolean wasSilent = sequence >= 0 && nanos - heardNanos > longest;
    double seconds = (nanos - heardNanos) / 1e9;
    missed += gap;
    sequence = number;
    heard = now;
    heardNanos = nanos;
    state = State.IN_REACH;
    @Nullable PoseEstimate last = poses.peekLast();
    if (last != null && !pose.measured().isAfter(last.measured())) {
      poses.clear(); // its clock was set
    }
    poses.addLast(pose);
    if (poses.size() > KEPT) {
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

  /** Looks whether it has fallen silent; says so once. */
  Optional<String> look(long nanos, long longest) {
    if (state == State.OUT_OF_REACH || nanos - heardNanos <= longest) {
      return Optional.empty();
    }
    state = State.OUT_OF_REACH;
    return Optional.of(
        String.format(
            Locale.ROOT,
            "%s is out of reach: nothing is heard of it for %.0f s",
            robot,
            (nanos - heardNanos) / 1e9));
  }

  /** What is known of it, by the newest of its poses at whose instant the asker was somewhere. */
  TeamMate seenFrom(OwnTrail own) {
    @Nullable PoseEstimate here = own.newest();
    @Nullable PoseEstimate there = poses.peekLast();
    @Nullable ClockOffset mine = here == null ? null : here.clockOffset();
    @Nullable ClockOffset its = there == null ? null : there.clockOffset();
    clock = mine == null || its == null ? null : its.against(mine);
    if (clock == null) {
      near = null;
    } else {
      TeamMate.@Nullable Near newest = newest(own, clock);
      near = newest == null ? near : newest;
    }
    return new TeamMate(robot, heard, state == State.OUT_OF_REACH, missed, clock, near);
  }

  private TeamMate.@Nullable Near newest(OwnTrail own, ClockOffset offset) {
    for (Iterator<PoseEstimate> all = poses.descendingIterator(); all.hasNext(); ) {
      PoseEstimate there = all.next();
      Instant at = offset.onTheOther(there.measured());
      OwnTrail.@Nullable Place here = own.at(at);
      if (here != null) {
        return near(at, here, there, offset);
      }
    }
    return null;
  }

  private static TeamMate.Near near(
      Instant at, OwnTrail.Place here, PoseEstimate there, ClockOffset offset) {
    PoseEstimate own = here.nearest();
    LocalPosition place = new LocalFrame(own.datum()).toLocal(there.position());
    double way = (Math.abs(own.speed()) + Math.abs(there.speed())) * offset.secondsWithin();
    return new TeamMate.Near(
        at,
        place.east() - here.east(),
        place.north() - here.north(),
        Math.hypot(own.positionSigma(), there.positionSigma()) + way);
  }
}
