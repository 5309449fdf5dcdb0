package org.dfra.core.time;

import java.time.Duration;
import java.util.Locale;

/**
 * How long something took, and how far the computer itself was to blame.
 *
 * @param took from begin to end, monotonic time
 * @param stalled for how much of it the computer ran no program that was due
 * @param load threads that ran or wanted to, per processor, on average; above 1 each runs slower
 */
public record Timing(Duration took, Duration stalled, double load) {

  /** Below this sum of stalls a computer counts as one that ran its programs on time. */
  private static final Duration STALL = Duration.ofMillis(100);

  /** From so many runnable threads per processor on a computer counts as overloaded. */
  private static final double OVERLOAD = 2;

  /** Whether the computer stalled meanwhile, or was overloaded. */
  public boolean isStalled() {
    return stalled.compareTo(STALL) >= 0 || load >= OVERLOAD;
  }

  /** What it would have taken on a computer that did not stall and was not overloaded. */
  public Duration adjusted() {
    if (!isStalled()) {
      return took;
    }
    double seconds = (took.toNanos() - stalled.toNanos()) / 1e9;
    return Duration.ofNanos((long) (seconds / (load >= OVERLOAD ? load : 1) * 1e9));
  }

  /** How it compares with a bound. */
  public Outcome against(Duration bound) {
    if (took.compareTo(bound) <= 0) {
      return Outcome.MET;
    }
    return adjusted().compareTo(bound) <= 0 ? Outcome.MISSED_DURING_A_STALL : Outcome.MISSED;
  }

  /**
   * Returns if the bound was kept. Returns, too, and prints a line that says so, if it was missed
   * and a stall or an overload explains that.
   *
   * @throws AssertionError if it was missed and nothing explains that
   */
  public void requireWithin(String what, Duration bound) {
    switch (against(bound)) {
      case MET -> {}
      case MISSED_DURING_A_STALL ->
          System.out.println("MISSED DURING A STALL: " + sentence(what, bound));
      case MISSED -> throw new AssertionError(sentence(what, bound));
    }
  }

  private String sentence(String what, Duration bound) {
    return String.format(
        Locale.ROOT,
        "%s took %.3f s, bound %.3f s; the computer stalled for %.3f s of it, with %.1f runnable"
            + " threads per processor",
        what,
        took.toNanos() / 1e9,
        bound.toNanos() / 1e9,
        stalled.toNanos() / 1e9,
        load);
  }

  /** How a time compares with its bound. */
  public enum Outcome {
    /** It was kept. */
    MET,
    /** It was missed, and would have been kept on a computer that runs its programs on time. */
    MISSED_DURING_A_STALL,
    /** It was missed. */
    MISSED
  }
}
