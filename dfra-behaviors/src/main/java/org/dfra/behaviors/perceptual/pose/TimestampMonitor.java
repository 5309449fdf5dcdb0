package org.dfra.behaviors.perceptual.pose;

/**
 * Checks whether a stream's timestamps are continuous. If one is far from the last, it is invalid,
 * the clock was set, or the stream paused: it is accepted when the next one agrees with it.
 *
 * <pre>
 *             near and later: NEXT, near and not later: OUT_OF_ORDER
 *                .--.
 *                v  |      far: SUSPECT
 *   FIRST ---&gt; continuous ----------------&gt; suspect
 *                ^      near the suspect:     |  ^  | far from both: SUSPECT
 *                |      BREAK                 |  `--'
 *                `----------------------------'
 *                  near the last: NEXT or OUT_OF_ORDER
 * </pre>
 */
final class TimestampMonitor {

  /** Maximum distance of near times: 5 s. */
  static final long MAX_STEP_NANOS = 5 * EpochNanos.SECOND;

  /** Classification of a time by the previous ones. */
  enum Classification {
    /** The first. */
    FIRST,
    /** Later than the last, and near it. */
    NEXT,
    /** Not later than the last, and near it. */
    OUT_OF_ORDER,
    /** Far from all before it; not accepted yet. */
    SUSPECT,
    /**
     * The stream continues at another time: later after a pause, or earlier because the clock was
     * set.
     */
    JUMP
  }

  private boolean hasBegun;
  private long last;
  private boolean hasSuspect;
  private long suspect;

  Classification classify(long time) {
    if (!hasBegun) {
      hasBegun = true;
      last = time;
      return Classification.FIRST;
    }
    if (Math.abs(time - last) <= MAX_STEP_NANOS) {
      hasSuspect = false;
      if (time <= last) {
        return Classification.OUT_OF_ORDER;
      }
      last = time;
      return Classification.NEXT;
    }
    if (hasSuspect && time > suspect && time - suspect <= MAX_STEP_NANOS) {
      hasSuspect = false;
      last = time;
      return Classification.JUMP;
    }
    hasSuspect = true;
    suspect = time;
    return Classification.SUSPECT;
  }
}
