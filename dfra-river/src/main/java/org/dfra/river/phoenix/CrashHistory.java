package org.dfra.river.phoenix;

import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.util.ArrayDeque;
import java.util.Optional;
import org.jspecify.annotations.Nullable;

/** The crashes of one group, and what the policy makes of them. Confined to the group's lock. */
final class CrashHistory {

  private final RestartPolicy policy;
  private final InstantSource clock;
  private final ArrayDeque<Instant> recent = new ArrayDeque<>();
  private int total;
  private @Nullable String last;
  private @Nullable Instant heldOffUntil;

  CrashHistory(RestartPolicy policy, InstantSource clock) {
    this.policy = policy;
    this.clock = clock;
  }

  /**
   * Notes a crash.
   *
   * @param how the group ended, as the rest of a sentence
   */
  void crashed(String how) {
    Instant now = clock.instant();
    forgetOld(now);
    recent.addLast(now);
    total++;
    last = how;
    if (recent.size() >= policy.limit()) {
      heldOffUntil = now.plus(policy.holdOff());
    }
  }

  /**
   * The delay before the next start by the daemon itself; empty where it leaves the group alone.
   */
  Optional<Duration> restartDelay() {
    return heldOffUntil().isPresent() ? Optional.empty() : Optional.of(policy.delay(recentCount()));
  }

  /** Until when nobody can start the group, where it is held off. */
  Optional<Instant> heldOffUntil() {
    Instant until = heldOffUntil;
    return until != null && clock.instant().isBefore(until) ? Optional.of(until) : Optional.empty();
  }

  /** Crashes that still count. */
  int recentCount() {
    forgetOld(clock.instant());
    return recent.size();
  }

  /** Crashes since the daemon started. */
  int total() {
    return total;
  }

  /** How the group ended the last time it crashed. */
  Optional<String> last() {
    return Optional.ofNullable(last);
  }

  private void forgetOld(Instant now) {
    Instant oldest = now.minus(policy.window());
    while (!recent.isEmpty() && recent.getFirst().isBefore(oldest)) {
      recent.removeFirst();
    }
  }
}
