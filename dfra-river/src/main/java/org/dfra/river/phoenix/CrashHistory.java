package org.dfra.river.phoenix;

import java.time.Duration;
import java.util.ArrayDeque;
import java.util.Optional;
import java.util.function.LongSupplier;
import org.jspecify.annotations.Nullable;

/**
 * The crashes of one group, and what the policy makes of them. Confined to the group's lock.
 *
 * <p>Time is monotonic: a computer's clock that is set, as a receiver does a minute after a cold
 * start, neither holds a group off nor lets it go. Nothing of this outlives the daemon.
 */
final class CrashHistory {

  private final RestartPolicy policy;
  private final LongSupplier nanos;
  private final ArrayDeque<RecordedExit> recent = new ArrayDeque<>();
  private int total;
  private @Nullable String last;
  private boolean isHeldOff;
  private long heldOffUntil; // nanos; means nothing unless isHeldOff
  private boolean lastWorked;

  /**
   * An end.
   *
   * @param lengthensDelay whether it makes the delay of the next start longer
   * @param isRequested whether it is no crash: then it does not count towards the limit
   */
  private record RecordedExit(long nanos, boolean lengthensDelay, boolean isRequested) {
    boolean isCrash() {
      return !isRequested;
    }
  }

  /**
   * @param nanos monotonic time in nanoseconds, such as {@link System#nanoTime}
   */
  CrashHistory(RestartPolicy policy, LongSupplier nanos) {
    this.policy = policy;
    this.nanos = nanos;
  }

  /**
   * Notes a crash.
   *
   * @param description the group ended, as the rest of a sentence
   * @param wasStable whether the group's modules had been ready for as long as the policy wants
   */
  void recordCrash(String description, boolean wasStable) {
    long now = nanos.getAsLong();
    forgetOld(now);
    lastWorked = wasStable;
    recent.addLast(new RecordedExit(now, !lastWorked, false));
    total++;
    last = description;
    if (!lastWorked
        && recent.stream()
                .filter(RecordedExit::lengthensDelay)
                .filter(RecordedExit::isCrash)
                .count()
            >= policy.crashLimit()) {
      isHeldOff = true;
      heldOffUntil = now + policy.holdOff().toNanos();
    }
  }

  /** Notes an end that somebody asked for. */
  void recordRequestedExit(boolean worked) {
    long now = nanos.getAsLong();
    forgetOld(now);
    lastWorked = worked;
    recent.addLast(new RecordedExit(now, !worked, true));
  }

  private int counted() {
    return (int) recent.stream().filter(RecordedExit::lengthensDelay).count();
  }

  /**
   * The delay before the next start by the daemon itself; empty where it leaves the group alone.
   */
  Optional<Duration> restartDelay() {
    if (remainingHoldOff().isPresent()) {
      return Optional.empty();
    }
    forgetOld(nanos.getAsLong());
    return Optional.of(lastWorked ? Duration.ZERO : policy.delay(counted()));
  }

  /** How long from now nobody can start the group, where it is held off. */
  Optional<Duration> remainingHoldOff() {
    long left = isHeldOff ? heldOffUntil - nanos.getAsLong() : 0;
    isHeldOff = left > 0;
    return isHeldOff ? Optional.of(Duration.ofNanos(left)) : Optional.empty();
  }

  /** Crashes within the window, whether they count towards the limit or not. */
  int recentCount() {
    forgetOld(nanos.getAsLong());
    return (int) recent.stream().filter(RecordedExit::isCrash).count();
  }

  /** Crashes since the daemon started. */
  int total() {
    return total;
  }

  /** How the group ended the last time it crashed. */
  Optional<String> lastCrash() {
    return Optional.ofNullable(last);
  }

  private void forgetOld(long now) {
    while (!recent.isEmpty() && now - recent.getFirst().nanos() > policy.window().toNanos()) {
      recent.removeFirst();
    }
  }
}
