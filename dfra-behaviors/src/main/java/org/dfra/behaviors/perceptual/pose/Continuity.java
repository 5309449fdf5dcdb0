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
final class Continuity {

  /** How far apart near times are at most: 5 s. */
  static final long NEAR = 5 * Ticks.SECOND;

  /** What a time is to those before it. */
  enum Verdict {
    /** The first. */
    FIRST,
    /** Later than the last, and near it. */
    NEXT,
    /** Not later than the last, and near it. */
    OLD,
    /** Far from all before it; not to be believed yet. */
    SUSPECT,
    /** The stream goes on elsewhere: later after a silence, or earlier by a clock that was set. */
    BREAK
  }

  private boolean hasBegun;
  private long last;
  private boolean hasSuspect;
  private long suspect;

  Verdict judge(long time) {
    if (!hasBegun) {
      hasBegun = true;
      last = time;
      return Verdict.FIRST;
    }
    if (Math.abs(time - last) <= NEAR) {
      hasSuspect = false;
      if (time <= last) {
        return Verdict.OLD;
      }
      last = time;
      return Verdict.NEXT;
    }
    if (hasSuspect && time > suspect && time - suspect <= NEAR) {
      hasSuspect = false;
      last = time;
      return Verdict.BREAK;
    }
    hasSuspect = true;
    suspect = time;
    return Verdict.SUSPECT;
  }
}
