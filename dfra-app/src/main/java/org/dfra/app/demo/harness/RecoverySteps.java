package org.dfra.app.demo.harness;

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
import org.dfra.river.phoenix.GroupStatus;

/**
 * When each step of a recovery was seen first, so that one that takes too long can be distinguished
 * from the others. Real time. A thread of its own looks ten times a second, since whoever answers
 * may be slow then: a step is seen no more exactly than that. Safe for use by several threads.
 */
public final class RecoverySteps implements AutoCloseable {

  /** Between the end of one look and the next. */
  private static final Duration PERIOD = Duration.ofMillis(100);

  /** After that nobody looks any more. */
  private static final Duration LONGEST = Duration.ofMinutes(2);

  /** Whether a step has been taken. */
  @FunctionalInterface
  public interface Step {
    /** Answers soon, and changes nothing: a call to what is dead would bring it back. */
    boolean isTaken() throws IOException;
  }

  private final Map<String, Step> open = new LinkedHashMap<>(); // guarded by this
  private final Map<String, Duration> taken = new LinkedHashMap<>(); // guarded by this
  private final LongSupplier nanos;
  private final long begin;
  private final ScheduledExecutorService looks =
      new ScheduledThreadPoolExecutor(1, RecoverySteps::thread);

  private static Thread thread(Runnable looks) {
    Thread thread = new Thread(looks, "recovery-steps");
    thread.setDaemon(true);
    return thread;
  }

  /** Begins to measure. */
  public RecoverySteps() {
    this(System::nanoTime);
  }

  RecoverySteps(LongSupplier nanos) {
    this.nanos = nanos;
    this.begin = nanos.getAsLong();
  }

  /**
   * The steps of a service group whose process is killed now.
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

  /** One more, which may be taken before those that were named earlier. */
  public synchronized RecoverySteps step(String name, Step step) {
    open.put(name, step);
    return this;
  }

  /** Looks at them from now on, until all are taken, this is closed or two minutes have passed. */
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

  /** Looks which steps have been taken since the last look. */
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
      return false; // whoever knows does not answer yet, and is asked again
    }
  }

  private synchronized void take(String step) {
    open.remove(step);
    taken.put(step, Duration.ofNanos(nanos.getAsLong() - begin));
  }

  /** Nobody looks any more. */
  @Override
  public void close() {
    looks.shutdownNow();
  }

  /**
   * The steps in the order they were seen, then those that were not: {@code noticed 0.1 s, ...}.
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
