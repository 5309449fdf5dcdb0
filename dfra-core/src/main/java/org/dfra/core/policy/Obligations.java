package org.dfra.core.policy;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import org.dfra.core.policy.method.MethodKind;
import org.jspecify.annotations.Nullable;

/**
 * What a rule obliges to when it decides about a call.
 *
 * @param rate how often one caller may make such calls; null if there is no limit
 * @param isLogged whether the call is written to the log
 * @param isNotified whether operators are notified of the call
 * @param isConfirmed whether the call needs an operator's confirmation
 */
public record Obligations(
    @Nullable RateLimit rate, boolean isLogged, boolean isNotified, boolean isConfirmed) {

  /** No obligations. */
  public static final Obligations NONE = new Obligations(null, false, false, false);

  /**
   * A limit for the calls of one caller.
   *
   * @param max the most calls in any period of this length, 1 to {@value #MAX_CALLS}
   * @param per the length, up to {@value #MAX_SECONDS} s
   */
  public record RateLimit(int max, Duration per) {

    /** The largest number of calls. */
    public static final int MAX_CALLS = 1000;

    /** The longest period in seconds. */
    public static final int MAX_SECONDS = 3600;

    /**
     * Checks them.
     *
     * @throws IllegalArgumentException if one is outside its limits
     */
    public RateLimit {
      if (max < 1 || max > MAX_CALLS) {
        throw new IllegalArgumentException("max " + max + " is outside 1 to " + MAX_CALLS);
      }
      if (per.isNegative() || per.isZero() || per.compareTo(Duration.ofSeconds(MAX_SECONDS)) > 0) {
        throw new IllegalArgumentException(
            "per " + per.toMillis() + " ms is outside 1 ms to " + MAX_SECONDS + " s");
      }
    }

    @Override
    public String toString() {
      return "at most " + max + (max == 1 ? " call" : " calls") + " in " + text(per);
    }

    private static String text(Duration time) {
      long millis = time.toMillis();
      return millis % 1000 == 0 ? millis / 1000 + " s" : millis + " ms";
    }
  }

  /** Those for a method of a kind: a stop waits for nobody and is never one too many. */
  public Obligations of(MethodKind kind) {
    return kind == MethodKind.STOP && isChecked()
        ? new Obligations(null, isLogged, isNotified, false)
        : this;
  }

  /** What this and another rule together oblige to report; each checks its own rate. */
  Obligations and(Obligations other) {
    return this == NONE
        ? other
        : new Obligations(
            null,
            isLogged || other.isLogged,
            isNotified || other.isNotified,
            isConfirmed || other.isConfirmed);
  }

  /** Whether a call must be counted or confirmed before it may run. */
  boolean isChecked() {
    return rate != null || isConfirmed;
  }

  /** The names of their elements in a policy, such as {@code log}; empty if there are none. */
  List<String> names() {
    List<String> names = new ArrayList<>();
    if (isConfirmed) {
      names.add("ask");
    }
    if (rate != null) {
      names.add("rate");
    }
    if (isLogged) {
      names.add("log");
    }
    if (isNotified) {
      names.add("notify");
    }
    return List.copyOf(names);
  }

  /** The obligations in words; empty if there are none. */
  public List<String> inWords() {
    List<String> words = new ArrayList<>();
    if (isConfirmed) {
      words.add("an operator must confirm it");
    }
    if (rate != null) {
      words.add(rate.toString());
    }
    if (isLogged) {
      words.add("it is logged");
    }
    if (isNotified) {
      words.add("operators are notified");
    }
    return words;
  }
}
