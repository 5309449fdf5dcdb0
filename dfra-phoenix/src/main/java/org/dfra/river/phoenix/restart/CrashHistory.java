package org.dfra.river.phoenix.restart;

import java.time.Duration;
import java.util.ArrayDeque;
import java.util.Optional;
import java.util.function.LongSupplier;
import org.jspecify.annotations.Nullable;

/**
 * The crashes of one group, and the delays that the policy derives from them. Confined to the
 * group's lock.
 *
 * <p>Time is monotonic. A change of the system clock, such as a GPS receiver causes a minute after
 * a cold start, neither starts nor ends a hold-off. The history is not stored: it ends with the
 * daemon.
 */
public final class CrashHistory {

  private final RestartPolicy policy;
  private final LongSupplier nanos;
  private final ArrayDeque<RecordedExit> recent = new ArrayDeque<>();
  private int total;
  private @Nullable String last;
  private boolean isHeldOff;
  private long heldOffUntil; // nanos; meaningful only if isHeldOff
  private boolean lastWorked;

  /**
   * One exit.
   *
   * @param lengthensDelay whether it lengthens the delay of the next start
   * @param isRequested whether it was requested: then it is no crash and does not count towards the
   *     limit
   */
  private record RecordedExit(long nanos, boolean lengthensDelay, boolean isRequested) {
    boolean isCrash() {
      return !isRequested;
    }
  }

  /**
   * @param nanos monotonic time in nanoseconds, such as {@link System#nanoTime}
   */
  public CrashHistory(RestartPolicy policy, LongSupplier nanos) {
    this.policy = policy;
    this.nanos = nanos;
  }

  /**
   * Records a crash.
   *
   * @param description how the group ended, the rest of a sentence after its name
   * @param wasStable whether the group's modules were ready for {@code minReadyTime} without
   *     interruption
   */
  public void recordCrash(String description, boolean wasStable) {
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

  /** Records an exit that was requested. */
  public void recordRequestedExit(boolean worked) {
    long now = nanos.getAsLong();
    forgetOld(now);
    lastWorked = worked;
    recent.addLast(new RecordedExit(now, !worked, true));
  }

  private int counted() {
    return (int) recent.stream().filter(RecordedExit::lengthensDelay).count();
  }

  /** The delay before the daemon restarts the group; empty if the daemon does not restart it. */
  public Optional<Duration> restartDelay() {
    if (remainingHoldOff().isPresent()) {
      return Optional.empty();
    }
    forgetOld(nanos.getAsLong());
    return Optional.of(lastWorked ? Duration.ZERO : policy.delay(counted()));
  }

  /** The time for which no start is permitted; empty if the group is not held off. */
  public Optional<Duration> remainingHoldOff() {
    long left = isHeldOff ? heldOffUntil - nanos.getAsLong() : 0;
    isHeldOff = left > 0;
    return isHeldOff ? Optional.of(Duration.ofNanos(left)) : Optional.empty();
  }

  /** Crashes within the window, including those that do not count towards the limit. */
  public int recentCount() {
    forgetOld(nanos.getAsLong());
    return (int) recent.stream().filter(RecordedExit::isCrash).count();
  }

  /** Crashes since the daemon started. */
  public int total() {
    return total;
  }

  /** How the group's last crash happened. */
  public Optional<String> lastCrash() {
    return Optional.ofNullable(last);
  }

  private void forgetOld(long now) {
    while (!recent.isEmpty() && now - recent.getFirst().nanos() > policy.window().toNanos()) {
      recent.removeFirst();
    }
  }

  /**
   * How a process exited.
   *
   * @param description the rest of a sentence that begins with the group's name
   * @param isRequested whether an orderly exit was requested; the daemon itself does not request it
   *     by a signal
   */
  public record ProcessExit(String description, boolean isRequested) {

    /** Exit code of a virtual machine that SIGTERM shut down: 128 and the signal's number. */
    private static final int TERMINATED = 143;

    /** An exit that nobody requested. */
    public static ProcessExit unrequested(String how) {
      return new ProcessExit(how, false);
    }

    /** The exit of a process with an exit code. */
    public static ProcessExit of(int exitCode) {
      return new ProcessExit("ended (exit code " + exitCode + ")", exitCode == TERMINATED);
    }
  }
}
