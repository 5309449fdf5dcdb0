package org.dfra.examples.mission.process;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import java.io.IOException;
import java.time.Duration;
import java.util.LinkedHashMap;
import java.util.Locale;
import java.util.Map;
import java.util.StringJoiner;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.ScheduledThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import java.util.function.LongSupplier;
import org.dfra.examples.harness.DemoRobot;
import org.dfra.river.phoenix.GroupStatus;

/**
 * Records when each step of a recovery was first observed, so that a slow step can be distinguished
 * from the others. Real time. A separate thread polls ten times a second, since the queried
 * processes may be slow then; the resolution is limited to that period. Thread-safe.
 */
final class RecoverySteps implements AutoCloseable {

  /** Between the end of one poll and the next. */
  private static final Duration PERIOD = Duration.ofMillis(100);

  /** Polling ends after this time. */
  private static final Duration LONGEST = Duration.ofMinutes(2);

  /** Condition of a completed step. */
  @FunctionalInterface
  public interface Step {
    /** Returns quickly, and changes nothing: a call to a dead service would reactivate it. */
    boolean isTaken() throws IOException;
  }

  @GuardedBy("this")
  private final Map<String, Step> open = new LinkedHashMap<>();

  @GuardedBy("this")
  private final Map<String, Duration> taken = new LinkedHashMap<>();

  private final LongSupplier nanos;
  private final long begin;
  private final ScheduledExecutorService looks =
      new ScheduledThreadPoolExecutor(1, RecoverySteps::thread);

  private static Thread thread(Runnable looks) {
    Thread thread = new Thread(looks, "recovery-steps");
    thread.setDaemon(true);
    return thread;
  }

  /** Starts the measurement. */
  public RecoverySteps() {
    this(System::nanoTime);
  }

  RecoverySteps(LongSupplier nanos) {
    this.nanos = nanos;
    this.begin = nanos.getAsLong();
  }

  /**
   * The recovery steps of a service group whose process is killed now.
   *
   * @param group the group's name without the robot's
   * @param process that is killed
   */
  public static RecoverySteps of(DemoRobot robot, String group, long process) {
    String name = robot.name() + "." + group;
    return new RecoverySteps()
        .step("noticed by phoenix", () -> robot.host().group(name).pid() != process)
        .step("new process", () -> isNew(robot.host().group(name), process))
        .step("process serves", () -> serves(robot.host().group(name), process));
  }

  private static boolean isNew(GroupStatus status, long before) {
    return status.pid() > 0 && status.pid() != before;
  }

  private static boolean serves(GroupStatus status, long before) {
    return isNew(status, before) && status.state() == GroupStatus.State.ACTIVE;
  }

  /** Adds a step, which may complete before earlier ones. */
  public synchronized RecoverySteps step(String name, Step step) {
    open.put(name, step);
    return this;
  }

  /** Polls from now on, until all steps are complete, this is closed or two minutes have passed. */
  public RecoverySteps watch() {
    long period = PERIOD.toNanos();
    looks.scheduleWithFixedDelay(this::lookOrEnd, 0, period, TimeUnit.NANOSECONDS);
    return this;
  }

  private void lookOrEnd() {
    look();
    if (stillOpen().isEmpty() || nanos.getAsLong() - begin > LONGEST.toNanos()) {
      close();
    }
  }

  /** Records the steps completed since the last poll. */
  void look() {
    for (Map.Entry<String, Step> each : stillOpen().entrySet()) {
      if (isTaken(each.getValue())) {
        take(each.getKey());
      }
    }
  }

  private synchronized Map<String, Step> stillOpen() {
    return new LinkedHashMap<>(open);
  }

  private static boolean isTaken(Step step) {
    try {
      return step.isTaken();
    } catch (IOException e) {
      return false; // the service does not answer yet, and is polled again
    }
  }

  private synchronized void take(String step) {
    open.remove(step);
    taken.put(step, Duration.ofNanos(nanos.getAsLong() - begin));
  }

  /** Ends the polling. */
  @Override
  public void close() {
    looks.shutdownNow();
  }

  /**
   * The steps in the order of their completion, then the incomplete ones: {@code noticed 0.1 s,
   * ...}.
   */
  @Override
  public synchronized String toString() {
    StringJoiner all = new StringJoiner(", ");
    taken.forEach(
        (name, after) ->
            all.add(String.format(Locale.ROOT, "%s %.1f s", name, after.toNanos() / 1e9)));
    open.keySet().forEach(name -> all.add(name + " not seen"));
    return all.toString();
  }
}
