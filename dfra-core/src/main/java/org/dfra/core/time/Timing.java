package org.dfra.core.time;

import java.io.PrintStream;
import java.time.Duration;
import java.util.Locale;

/**
 * How long something took, and how far the computer itself was to blame.
 *
 * <p>A bound is judged by {@link #requireWithin} in this order; the first line that applies counts:
 *
 * <ol>
 *   <li><b>Kept:</b> it took no longer than the bound. Nothing is printed.
 *   <li><b>Missed during a stall:</b> what it took less all stalls is within the bound, or less the
 *       time that the host gave to others, if that is longer. The test passes and prints {@code
 *       MISSED DURING A STALL: } with the measurements. Both count only where they are at least 100
 *       ms or a tenth of the bound, so a program that is late by itself is not excused by the usual
 *       lateness of timers.
 *   <li><b>Missed during an overload:</b> two or more threads per processor wanted to run on
 *       average, and what it took less the stalls, divided by that average, is within the bound. An
 *       overload may come from the tests themselves, several of which run at a time, so this is no
 *       result yet. Where the property {@value #REPEATS} promises that the missed bound is reported
 *       by {@code ./dfra test} the test passes and prints {@code MISSED DURING AN OVERLOAD: }. Its
 *       class is then repeated alone, where load excuses nothing. The everyday tier repeats three
 *       classes at most; the closing lines name the others. Elsewhere the test fails.
 *   <li><b>Missed:</b> the test fails with the measurements.
 * </ol>
 *
 * <p>The bound itself is the requirement's, with no more added than the test needs for looking (say
 * 0.1 s between two looks). How long a test <em>waits</em> for what it measures is another matter:
 * that may be long, so that what comes too late is still measured.
 *
 * @param took from begin to end, monotonic time
 * @param stalled for how much of it the computer ran no program that was due
 * @param load threads that ran or wanted to, per processor, on average; above 1 each runs slower
 * @param stolen for how much of it at most programs were without a processor that they wanted,
 *     since the host of this virtual computer gave it to others; it may contain what has stalled
 */
public record Timing(Duration took, Duration stalled, double load, Duration stolen) {

  /**
   * The system property that is {@code true} where {@code ./dfra test} looks for bounds that were
   * missed during an overload. Elsewhere load excuses nothing.
   */
  public static final String REPEATS = "dfra.repeats";

  /** Below this sum of stalls a computer counts as one that ran its programs on time. */
  private static final Duration STALL = Duration.ofMillis(100);

  /** Nor does a bound bear more: stalls of a tenth of it count in any case. */
  private static final int SHARE = 10;

  /** From so many runnable threads per processor on a computer counts as overloaded. */
  private static final double OVERLOAD = 2;

  /** On a computer whose host, if any, gave it its processors all the time. */
  public Timing(Duration took, Duration stalled, double load) {
    this(took, stalled, load, Duration.ZERO);
  }

  /**
   * A part of this time, of which nobody knows when it was: any stall may have been in it, and its
   * share of what the host gave to others.
   *
   * @param part how long it was
   */
  public Timing ofPart(Duration part) {
    double share = took.isZero() ? 0 : Math.min(1, (double) part.toNanos() / took.toNanos());
    return new Timing(part, stalled, load, Duration.ofNanos((long) (stolen.toNanos() * share)));
  }

  /**
   * What it would have taken on a computer that did not stall; stalls that are short do not count.
   */
  private Duration withoutStalls(Duration bound) {
    Duration lost = stalled.compareTo(stolen) >= 0 ? stalled : stolen;
    boolean counts = lost.compareTo(STALL) >= 0 || lost.multipliedBy(SHARE).compareTo(bound) >= 0;
    return counts ? took.minus(lost) : took;
  }

  /** What that would have taken on a computer that was not overloaded. */
  private Duration onAnIdleOne(Duration time) {
    return Duration.ofNanos((long) (load >= OVERLOAD ? time.toNanos() / load : time.toNanos()));
  }

  /** How it compares with a bound. */
  public BoundResult compareWith(Duration bound) {
    if (took.compareTo(bound) <= 0) {
      return BoundResult.MET;
    }
    Duration own = withoutStalls(bound);
    if (own.compareTo(bound) <= 0) {
      return BoundResult.MISSED_DURING_A_STALL;
    }
    return onAnIdleOne(own).compareTo(bound) <= 0
        ? BoundResult.MISSED_DURING_AN_OVERLOAD
        : BoundResult.MISSED;
  }

  /**
   * Returns if the bound was kept. Returns, too, and prints a line that says so, if it was missed
   * and a stall explains that, or if an overload explains it and the test is going to be repeated.
   *
   * @throws AssertionError if it was missed and nothing explains that
   */
  public void requireWithin(String what, Duration bound) {
    requireWithin(what, bound, Boolean.getBoolean(REPEATS), System.out);
  }

  /** The same, for a test that is repeated or not, with a place for the line. */
  void requireWithin(String what, Duration bound, boolean repeats, PrintStream out) {
    String missed =
        String.format(
            Locale.ROOT,
            "%s took %.3f s, bound %.3f s",
            what,
            took.toNanos() / 1e9,
            bound.toNanos() / 1e9);
    require(compareWith(bound), missed, repeats, out);
  }

  /**
   * How often something happened that is not to happen, unless the computer stalls.
   *
   * @param count how often it happened
   * @param each how long a stall is that explains it once
   */
  public BoundResult compareWith(long count, Duration each) {
    if (count == 0) {
      return BoundResult.MET;
    }
    if (count <= stalled.dividedBy(each)) {
      return BoundResult.MISSED_DURING_A_STALL;
    }
    Duration waited = took.minus(onAnIdleOne(took)).plus(stalled);
    return count <= waited.dividedBy(each)
        ? BoundResult.MISSED_DURING_AN_OVERLOAD
        : BoundResult.MISSED;
  }

  /**
   * Returns if something that is not to happen did not. Returns, too, and prints a line that says
   * so, if it happened no more often than stalls explain, or than an overload does and the test is
   * going to be repeated.
   *
   * @param what what happened
   * @param count how often it happened
   * @param each how long a stall is that explains it once
   * @throws AssertionError if it happened more often
   */
  public void requireNone(String what, long count, Duration each) {
    String missed =
        String.format(
            Locale.ROOT,
            "%s: %d, where only each stall of %.3f s explains one",
            what,
            count,
            each.toNanos() / 1e9);
    require(compareWith(count, each), missed, Boolean.getBoolean(REPEATS), System.out);
  }

  private void require(BoundResult outcome, String missed, boolean repeats, PrintStream out) {
    String sentence =
        String.format(
            Locale.ROOT,
            "%s; the computer stalled for %.3f s of it, with %.1f runnable threads per processor%s",
            missed,
            stalled.toNanos() / 1e9,
            load,
            steal());
    switch (outcome) {
      case MET -> {}
      case MISSED_DURING_A_STALL -> out.println("MISSED DURING A STALL: " + sentence);
      case MISSED_DURING_AN_OVERLOAD -> {
        if (!repeats) {
          throw new AssertionError(sentence);
        }
        // "./dfra test" looks for these words and repeats the test.
        out.println("MISSED DURING AN OVERLOAD: " + sentence);
      }
      case MISSED -> throw new AssertionError(sentence);
    }
  }

  /** What the host gave to others, as the end of a sentence; empty where that is little. */
  public String steal() {
    return stolen.compareTo(STALL) < 0
        ? ""
        : String.format(
            Locale.ROOT, "; its host gave %.3f s of it to others", stolen.toNanos() / 1e9);
  }

  /** How a time compares with its bound. */
  public enum BoundResult {
    /** It was kept. */
    MET,
    /** It was missed, and would have been kept on a computer that did not stall. */
    MISSED_DURING_A_STALL,
    /** It was missed, and would have been kept on a computer that had less to do. */
    MISSED_DURING_AN_OVERLOAD,
    /** It was missed. */
    MISSED
  }
}
