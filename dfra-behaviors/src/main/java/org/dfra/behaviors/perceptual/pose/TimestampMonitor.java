package org.dfra.behaviors.perceptual.pose;

/**
 * Whether a stream's times go on. One that is far from the last is either nonsense or the clock was
 * set or the stream was silent: it is believed when the next agrees with it.
 *
 * <pre>
 *             near and later: NEXT, near and not later: OLD
 *                .--.
 *                v  |      far: SUSPECT
 *   FIRST ---&gt; going on ------------------&gt; in doubt
 *                ^      near the suspect:     |  ^  | far from both: SUSPECT
 *                |      BREAK                 |  `--'
 *                `----------------------------'
 *                  near the last: NEXT or OLD
 * </pre>
 */
final class TimestampMonitor {

  /** How far apart near times are at most: 5 s. */
  static final long MAX_STEP_NANOS = 5 * EpochNanos.SECOND;

  /** What a time is to those before it. */
  enum Classification {
    /** The first. */
    FIRST,
    /** Later than the last, and near it. */
    NEXT,
    /** Not later than the last, and near it. */
    OUT_OF_ORDER,
    /** Far from all before it; not to be believed yet. */
    SUSPECT,
    /** The stream goes on elsewhere: later after a silence, or earlier by a clock that was set. */
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
