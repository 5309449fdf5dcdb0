package org.dfra.flow.effector;

import java.io.Serializable;
import java.time.Duration;
import java.time.Instant;
import java.util.Objects;
import org.jspecify.annotations.Nullable;

/**
 * Whether an effector is stopped for an emergency, see {@link Effector#emergencyStop}. Two are
 * equal where all but their ages are.
 *
 * @param latched whether it is: then it obeys nobody until it is released
 * @param requester who stopped it, or released it last, for people; null where nobody ever did, or
 *     nobody knows any more
 * @param since when that was, by the effector's clock, UTC, whole milliseconds; null likewise. For
 *     people, and to distinguish one stop from another: computers' clocks differ and are set.
 * @param haltCommanded whether its driver has been told to come to rest; false only while it is
 *     latched and the driver is held up, or where the driver failed
 * @param fault what is wrong with it, a clause or two for people; null where nothing is
 * @param age how long ago that was at least, by time that nobody sets, as of this answer; exact
 *     unless the effector's computer was booted since; null where {@code since} is
 */
public record EmergencyStopState(
    boolean latched,
    @Nullable String requester,
    @Nullable Instant since,
    boolean haltCommanded,
    @Nullable String fault,
    @Nullable Duration age)
    implements Serializable {

  /** Of unknown age. */
  public EmergencyStopState(
      boolean latched,
      @Nullable String by,
      @Nullable Instant since,
      boolean resting,
      @Nullable String fault) {
    this(latched, by, since, resting, fault, null);
  }

  /** Of an effector that was never stopped. */
  public static final EmergencyStopState NEVER =
      new EmergencyStopState(false, null, null, true, null);

  /** Characters of a requester's name that are kept. */
  private static final int LONGEST_NAME = 120;

  /** Of a longer text, no more than this is read: it may be of any length. */
  private static final int LONGEST_TEXT = 4 * LONGEST_NAME;

  /**
   * The name that is kept of whoever stops or releases an effector. Any text will do, also none: a
   * stop must not fail because of it.
   *
   * @param by who asks, as the caller says; any length, any characters
   * @return one line of at most 120 characters, with an ellipsis where it was longer; {@code
   *     somebody} where nothing can be read in it
   */
  public static String requesterName(@Nullable String by) {
    if (by == null) {
      return "somebody";
    }
    String text = by.length() <= LONGEST_TEXT ? by : by.substring(0, LONGEST_TEXT);
    // Controls, directions of writing, halves of characters and ends of lines garble a terminal.
    String line = text.replaceAll("[\\p{Cc}\\p{Cf}\\p{Cs}\\p{Zl}\\p{Zp}]+", " ").strip();
    if (line.isEmpty()) {
      return "somebody";
    } else if (line.codePointCount(0, line.length()) > LONGEST_NAME) {
      return line.substring(0, line.offsetByCodePoints(0, LONGEST_NAME)) + "…";
    }
    return text.length() < by.length() ? line + "…" : line;
  }

  @Override
  public boolean equals(@Nullable Object other) {
    return other instanceof EmergencyStopState that
        && latched == that.latched
        && haltCommanded == that.haltCommanded
        && Objects.equals(requester, that.requester)
        && Objects.equals(since, that.since)
        && Objects.equals(fault, that.fault);
  }

  @Override
  public int hashCode() {
    return Objects.hash(latched, requester, since, haltCommanded, fault);
  }

  /** Since when it is stopped and by whom, as far as that is known; for people. */
  public String inWords() {
    return (since == null ? "since a time not known" : "since " + since)
        + (requester == null ? "" : ", by " + requester);
  }
}
