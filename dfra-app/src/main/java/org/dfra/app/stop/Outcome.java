package org.dfra.app.stop;

import java.time.Duration;
import java.time.Instant;
import java.util.Locale;
import org.dfra.flow.effector.EmergencyStopState;
import org.jspecify.annotations.Nullable;

/**
 * What has become of one effector that was to be stopped or released.
 *
 * @param module the effector's path, {@code robot/name}
 * @param result what has become of it
 * @param requester who stopped or released it last, for people; null where that is not known
 * @param since when that was, by the effector's clock, UTC; null likewise
 * @param reason what is wrong, a clause; null where nothing is
 */
record Outcome(
    String module,
    Result result,
    @Nullable String requester,
    @Nullable Instant since,
    @Nullable String reason) {

  /** What can become of it. */
  enum Result {
    /** It is stopped by this call. */
    STOPPED("stopped"),
    /** It was stopped before, and has been told to come to rest once more. */
    ALREADY_STOPPED("was stopped already"),
    /** It obeys nobody, but its driver could not be told to come to rest yet. */
    DRIVER_NOT_STOPPED("NOT AT REST"),
    /** Something says that it is stopped, and its phoenix does not confirm that. */
    UNCONFIRMED("DOUBTFUL"),
    /** It was not reached, or not stopped. */
    NOT_STOPPED("NOT STOPPED"),
    /** It may be commanded again. */
    RELEASED("released"),
    /** There was nothing to release. */
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
   * Of an effector that was called to stop.
   *
   * @param running for how long this command has run: what is older was stopped before. Both are
   *     spans, since the clocks of two computers differ.
   * @param now what it answered
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
   * Of an effector that was called to release its stop.
   *
   * @param by who asked
   * @param now what it answered
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

  /** The same for people, one line. */
  String inWords() {
    return module
        + ": "
        + result.words()
        + (result == Result.ALREADY_STOPPED ? ", since " + since + ", by " + requester : "")
        + (reason == null ? "" : ": " + reason)
        + ".";
  }

  /** Its result for programs, {@code stopped_already} say. */
  String id() {
    return result.name().toLowerCase(Locale.ROOT);
  }
}
