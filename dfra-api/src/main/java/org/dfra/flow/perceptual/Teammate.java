package org.dfra.flow.perceptual;

import java.io.Serializable;
import java.time.Instant;
import org.dfra.time.ClockOffset;
import org.jspecify.annotations.Nullable;

/**
 * Another robot of the team, as one robot knows it.
 *
 * @param robot its name
 * @param lastReceived when its last message was received, by the receiver's clock, UTC
 * @param isOutOfReach whether no message was received for longer than usual
 * @param missedReadings readings that it published and that were not received since the receiver
 *     subscribed; a gap is counted when it ends
 * @param clockOffset how far its clock is ahead of the receiver's; null if unknown, because one of
 *     them has no satellite time
 * @param relativePosition its relative position; null before both positions are known for one
 *     instant, and if the clocks cannot be compared
 */
public record Teammate(
    String robot,
    Instant lastReceived,
    boolean isOutOfReach,
    long missedReadings,
    @Nullable ClockOffset clockOffset,
    @Nullable RelativePosition relativePosition)
    implements Serializable {

  public Teammate {
    if (missedReadings < 0) {
      throw new IllegalArgumentException(
          "of " + robot + " " + missedReadings + " readings are missed");
    }
    if (clockOffset == null && relativePosition != null) {
      throw new IllegalArgumentException(
          "the relative position of "
              + robot
              + " needs the offset of its clock; give both, or no position");
    }
  }

  /**
   * A teammate's estimated position relative to the receiver's estimated position at the same
   * instant.
   *
   * @param time the instant, by the receiver's clock, UTC
   * @param east metres east of the receiver, base to base
   * @param north metres north of it
   * @param sigma standard deviation of the distance, metres, from those of both positions; the
   *     uncertainty of the clock offset is added as the distance that both drive in that time
   */
  public record RelativePosition(Instant time, double east, double north, double sigma)
      implements Serializable {

    public RelativePosition {
      if (!(Double.isFinite(east + north) && sigma >= 0)) {
        throw new IllegalArgumentException(
            "a robot "
                + east
                + " m east, "
                + north
                + " m north, ± "
                + sigma
                + " m is not finite, or its sigma is below 0");
      }
    }

    /** From base to base, metres. */
    public double distance() {
      return Math.hypot(east, north);
    }
  }
}
