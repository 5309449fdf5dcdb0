package org.dfra.flow.perceptual;

import java.io.Serializable;
import java.time.Instant;
import org.dfra.time.ClockOffset;
import org.jspecify.annotations.Nullable;

/**
 * Another robot of the team, as a robot knows it.
 *
 * @param robot its name
 * @param lastReceived when it was last heard of, by the asker's clock, UTC
 * @param isOutOfReach whether nothing has been heard of it for longer than is usual
 * @param missedReadings readings that it told and that were not heard, since the asker began to
 *     listen; a gap is counted when it is over
 * @param clockOffset how far its clock is ahead of the asker's; null where that is unknown, since
 *     one of them has heard no satellite
 * @param relativePosition where it was; null before both were known to be somewhere at one instant,
 *     and where the clocks cannot be compared
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
          "where "
              + robot
              + " is at an instant of another robot's is not known without its clock's offset");
    }
  }

  /**
   * Where a robot believes it was, from where the asker believes it was at the same instant.
   *
   * @param time the instant, by the asker's clock, UTC
   * @param east metres east of the asker, base to base
   * @param north metres north of it
   * @param sigma standard deviation of the distance, metres, by those of both positions; what the
   *     clocks' offset may be off by is added as the way that both drive meanwhile
   */
  public record RelativePosition(Instant time, double east, double north, double sigma)
      implements Serializable {

    public RelativePosition {
      if (!(Double.isFinite(east + north) && sigma >= 0)) {
        throw new IllegalArgumentException(
            "a robot " + east + " m east, " + north + " m north, ± " + sigma + " m is nowhere");
      }
    }

    /** From base to base, metres. */
    public double distance() {
      return Math.hypot(east, north);
    }
  }
}
