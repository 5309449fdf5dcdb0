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
  private final ArrayDeque<Crash> recent = new ArrayDeque<>();
  private int total;
  private @Nullable String last;
  private boolean isHeldOff;
  private long heldOffUntil; // nanos; means nothing unless isHeldOff
  private boolean lastWorked;

  /** A crash, and whether it counts towards the limit. */
  private record Crash(long nanos, boolean counts) {}

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
   * @param how the group ended, as the rest of a sentence
   * @param worked whether the group's modules had been ready for as long as the policy wants
   */
  void crashed(String how, boolean worked) {
    long now = nanos.getAsLong();
    forgetOld(now);
    lastWorked = worked;
    recent.addLast(new Crash(now, !lastWorked));
    total++;
    last = how;
    if (!lastWorked && counted() >= policy.limit()) {
      isHeldOff = true;
      heldOffUntil = now + policy.holdOff().toNanos();
    }
  }

  private int counted() {
    return (int) recent.stream().filter(Crash::counts).count();
  }

  /**
   * The delay before the next start by the daemon itself; empty where it leaves the group alone.
   */
  Optional<Duration> restartDelay() {
    if (heldOffFor().isPresent()) {
      return Optional.empty();
    }
    forgetOld(nanos.getAsLong());
    return Optional.of(lastWorked ? Duration.ZERO : policy.delay(counted()));
  }

  /** How long from now nobody can start the group, where it is held off. */
  Optional<Duration> heldOffFor() {
    long left = isHeldOff ? heldOffUntil - nanos.getAsLong() : 0;
    isHeldOff = left > 0;
    return isHeldOff ? Optional.of(Duration.ofNanos(left)) : Optional.empty();
  }

  /** Crashes within the window, whether they count towards the limit or not. */
  int recentCount() {
    forgetOld(nanos.getAsLong());
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

  private void forgetOld(long now) {
    while (!recent.isEmpty() && now - recent.getFirst().nanos() > policy.window().toNanos()) {
      recent.removeFirst();
    }
  }
}
