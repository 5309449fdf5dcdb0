package org.dfra.flow.effector;

import java.io.Serializable;
import java.time.Duration;
import java.time.Instant;
import java.util.Objects;
import org.jspecify.annotations.Nullable;

/**
 * Whether an effector is in an emergency stop, see {@link Effector#emergencyStop}. Two states are
 * equal if all components but their ages are.
 *
 * @param latched whether it is stopped: then it executes no commands until it is released
 * @param requester the name of the client that stopped or released it last, for operators; null if
 *     it was never stopped, or the name is lost
 * @param since when that was, by the effector's clock, UTC, whole milliseconds; null likewise. For
 *     operators, and to distinguish stops; do not use it to measure time: clocks of computers
 *     differ and are set.
 * @param haltCommanded whether its driver has been commanded to stop; false only while it is
 *     latched and the driver blocks, or if the driver failed
 * @param fault its fault, a clause or two for operators; null if there is none
 * @param age minimum time since then by a monotonic clock, as of this answer; exact unless the
 *     effector's computer was rebooted since; null if {@code since} is
 */
public record EmergencyStopState(
    boolean latched,
    @Nullable String requester,
    @Nullable Instant since,
    boolean haltCommanded,
    @Nullable String fault,
    @Nullable Duration age)
    implements Serializable {

  /** A state of unknown age. */
  public EmergencyStopState(
      boolean latched,
      @Nullable String by,
      @Nullable Instant since,
      boolean resting,
      @Nullable String fault) {
    this(latched, by, since, resting, fault, null);
  }

  /** The state of an effector that was never stopped. */
  public static final EmergencyStopState NEVER =
      new EmergencyStopState(false, null, null, true, null);

  /** This state with another fault and another age. */
  public EmergencyStopState withFault(@Nullable String other, @Nullable Duration otherAge) {
    return new EmergencyStopState(latched, requester, since, haltCommanded, other, otherAge);
  }

  /** This state of a driver that has not been commanded to stop, with the fault. */
  public EmergencyStopState withoutHalt(@Nullable String why) {
    return new EmergencyStopState(latched, requester, since, false, why, age);
  }

  /** Characters of a requester's name that are kept. */
  private static final int LONGEST_NAME = 120;

  /** At most this many characters of a text are read: it may be of any length. */
  private static final int LONGEST_TEXT = 4 * LONGEST_NAME;

  /**
   * The stored name of a client that stops or releases an effector. Any text is accepted, also
   * null: a stop must not fail because of it.
   *
   * @param by the name that the caller gives; any length, any characters
   * @return one line of at most 120 characters, with an ellipsis where it was longer; {@code
   *     somebody} if it has no readable character
   */
  public static String requesterName(@Nullable String by) {
    if (by == null) {
      return "somebody";
    }
    String text = by.length() <= LONGEST_TEXT ? by : by.substring(0, LONGEST_TEXT);
    // Control and bidi characters, lone surrogates and line separators garble a terminal.
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

  /** Since when and by which client it is stopped, as far as known; for operators. */
  public String inWords() {
    return (since == null ? "since an unknown time" : "since " + since)
        + (requester == null ? "" : ", by " + requester);
  }
}
