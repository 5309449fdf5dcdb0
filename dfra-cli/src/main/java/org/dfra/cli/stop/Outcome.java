package org.dfra.cli.stop;

import java.time.Duration;
import java.time.Instant;
import java.util.Locale;
import org.dfra.flow.effector.EmergencyStopState;
import org.jspecify.annotations.Nullable;

/**
 * The outcome for one effector that was to be stopped or released.
 *
 * @param module the effector's path, {@code robot/name}
 * @param result the result
 * @param requester who requested its last stop or release, as text; null if unknown
 * @param since when that was, by the effector's clock, UTC; null likewise
 * @param reason of a failure, a clause; null if there is none
 */
record Outcome(
    String module,
    Result result,
    @Nullable String requester,
    @Nullable Instant since,
    @Nullable String reason) {

  /** The possible results. */
  enum Result {
    /** This call has stopped it. */
    STOPPED("stopped"),
    /** It was stopped before, and has received the stop command once more. */
    ALREADY_STOPPED("was stopped already"),
    /** It refuses all commands, but its driver could not be stopped yet. */
    DRIVER_NOT_STOPPED("DRIVER NOT STOPPED"),
    /** Its stop was reported, but its phoenix does not confirm that. */
    UNCONFIRMED("DOUBTFUL"),
    /** It was not reached, or not stopped. */
    NOT_STOPPED("NOT STOPPED"),
    /** It accepts commands again. */
    RELEASED("released"),
    /** It was not in emergency stop. */
    WAS_NOT_STOPPED("was not stopped"),
    /** It was not reached, or not released. */
    NOT_RELEASED("NOT RELEASED");

    private final String words;

    Result(String words) {
      this.words = words;
    }

    String words() {
      return words;
    }

    boolean isWell() {
      return this == STOPPED
          || this == ALREADY_STOPPED
          || this == RELEASED
          || this == WAS_NOT_STOPPED;
    }
  }

  /**
   * Of a stop call.
   *
   * @param running for how long this command has run: an older stop was there before. Both are
   *     durations, since the clocks of two computers differ.
   * @param now the effector's answer
   */
  static Outcome ofStop(String module, Duration running, EmergencyStopState now) {
    if (!now.latched()) {
      return new Outcome(
          module,
          Result.NOT_STOPPED,
          now.requester(),
          now.since(),
          "it was released at the same time by " + now.requester());
    }
    Result result =
        !now.haltCommanded()
            ? Result.DRIVER_NOT_STOPPED
            : now.age() != null && now.age().compareTo(running) > 0
                ? Result.ALREADY_STOPPED
                : Result.STOPPED;
    return new Outcome(module, result, now.requester(), now.since(), now.fault());
  }

  /**
   * Of a release call.
   *
   * @param by the requester
   * @param now the effector's answer
   */
  static Outcome ofRelease(String module, String by, EmergencyStopState now) {
    if (now.latched()) {
      return new Outcome(
          module,
          Result.NOT_RELEASED,
          now.requester(),
          now.since(),
          "it was stopped at the same time by " + now.requester());
    }
    Result result = by.equals(now.requester()) ? Result.RELEASED : Result.WAS_NOT_STOPPED;
    return new Outcome(module, result, now.requester(), now.since(), now.fault());
  }

  /** The same as text output, one line. */
  String inWords() {
    return module
        + ": "
        + result.words()
        + (result == Result.ALREADY_STOPPED ? ", since " + since + ", by " + requester : "")
        + (reason == null ? "" : ": " + reason)
        + ".";
  }

  /** Its result in JSON output, for example {@code stopped_already}. */
  String id() {
    return result.name().toLowerCase(Locale.ROOT);
  }
}
