package org.dfra.core.time;

import java.io.PrintStream;
import java.time.Duration;
import java.util.Locale;

/**
 * A measured duration, with the delays that the computer caused.
 *
 * <p>{@link #requireWithin} judges a bound in this order; the first line that applies counts:
 *
 * <ol>
 *   <li><b>Kept:</b> it took no longer than the bound. Nothing is printed.
 *   <li><b>Missed during a stall:</b> the duration minus all stalls is within the bound, or minus
 *       the steal time, if that is longer. The test passes and prints {@code MISSED DURING A STALL:
 *       } with the measurements. Both count only if they are at least 100 ms or a tenth of the
 *       bound, so the normal lateness of timers does not excuse a late program.
 *   <li><b>Missed during an overload:</b> two or more threads per processor were runnable on
 *       average, and the duration minus the stalls, divided by that average, is within the bound.
 *       The tests themselves may cause an overload, since several run at a time, so this is not a
 *       final result. If the property {@value #REPEATS} states that {@code ./dfra test} reports the
 *       missed bound, the test passes and prints {@code MISSED DURING AN OVERLOAD: }. Its class is
 *       then repeated alone, where load excuses nothing (at most three classes in the everyday
 *       tier; the closing lines name the others). Otherwise the test fails.
 *   <li><b>Missed:</b> the test fails with the measurements.
 * </ol>
 *
 * <p>The bound is the requirement's, plus at most the test's polling period (for example 0.1 s).
 * The timeout of a test's <em>wait</em> for the measured event may be much longer, so that a late
 * event is still measured.
 *
 * @param took duration from begin to end, monotonic time
 * @param stalled the part of it in which the computer ran no runnable program
 * @param load runnable threads per processor, on average; above 1 each runs slower
 * @param stolen upper estimate of the part in which runnable programs had no processor, since the
 *     host of this virtual machine assigned it to others; it may overlap {@code stalled}
 */
public record Timing(Duration took, Duration stalled, double load, Duration stolen) {

  /**
   * The system property that is {@code true} if {@code ./dfra test} reports bounds that were missed
   * during an overload. Otherwise load excuses nothing.
   */
  public static final String REPEATS = "dfra.test.repeats-overloaded";

  /** Below this sum of stalls the computer is assumed to have run its programs on time. */
  private static final Duration STALL = Duration.ofMillis(100);

  /** Stalls of at least this fraction (1/10) of the bound always count. */
  private static final int SHARE = 10;

  /** From this number of runnable threads per processor a computer counts as overloaded. */
  private static final double OVERLOAD = 2;

  /** A timing without steal time. */
  public Timing(Duration took, Duration stalled, double load) {
    this(took, stalled, load, Duration.ZERO);
  }

  /**
   * A part of this time, whose position in it is unknown: it may contain any stall, and has its
   * share of the steal time.
   *
   * @param part its duration
   */
  public Timing ofPart(Duration part) {
    double share = took.isZero() ? 0 : Math.min(1, (double) part.toNanos() / took.toNanos());
    return new Timing(part, stalled, load, Duration.ofNanos((long) (stolen.toNanos() * share)));
  }

  /** The duration on a computer without stalls; short stalls are ignored. */
  private Duration withoutStalls(Duration bound) {
    Duration lost = stalled.compareTo(stolen) >= 0 ? stalled : stolen;
    boolean counts = lost.compareTo(STALL) >= 0 || lost.multipliedBy(SHARE).compareTo(bound) >= 0;
    return counts ? took.minus(lost) : took;
  }

  /** That duration on a computer without overload. */
  private Duration onAnIdleOne(Duration time) {
    return Duration.ofNanos((long) (load >= OVERLOAD ? time.toNanos() / load : time.toNanos()));
  }

  /** Compares it with a bound. */
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
   * Returns if the bound was kept. If it was missed because of a stall, or because of an overload
   * and the test will be repeated, prints a line that reports this and returns.
   *
   * @throws AssertionError if it was missed and nothing explains that
   */
  public void requireWithin(String what, Duration bound) {
    requireWithin(what, bound, Boolean.getBoolean(REPEATS), System.out);
  }

  /** The same, with a given repetition mode and output stream. */
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
   * Judges the count of an event that may occur only if the computer stalls.
   *
   * @param count how often it happened
   * @param each duration of a stall that explains one occurrence
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
   * Returns if an unwanted event did not occur. If it occurred no more often than stalls explain,
   * or than an overload explains and the test will be repeated, prints a line that reports this and
   * returns.
   *
   * @param what the event
   * @param count how often it occurred
   * @param each duration of a stall that explains one occurrence
   * @throws AssertionError if it occurred more often
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
        // "./dfra test" searches for these words and repeats the test.
        out.println("MISSED DURING AN OVERLOAD: " + sentence);
      }
      case MISSED -> throw new AssertionError(sentence);
    }
  }

  /** The steal time, as the end of a sentence; empty if it is small. */
  public String steal() {
    return stolen.compareTo(STALL) < 0
        ? ""
        : String.format(
            Locale.ROOT, "; its host gave %.3f s of it to others", stolen.toNanos() / 1e9);
  }

  /** The result of comparing a time with its bound. */
  public enum BoundResult {
    /** The bound was kept. */
    MET,
    /** The bound was missed, but would have been kept on a computer without stalls. */
    MISSED_DURING_A_STALL,
    /** The bound was missed, but would have been kept on a computer without overload. */
    MISSED_DURING_AN_OVERLOAD,
    /** The bound was missed. */
    MISSED
  }
}
