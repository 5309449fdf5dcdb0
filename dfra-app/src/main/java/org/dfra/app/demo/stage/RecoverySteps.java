package org.dfra.app.demo.stage;

import java.io.IOException;
import java.time.Duration;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.StringJoiner;
import java.util.function.LongSupplier;
import org.dfra.river.phoenix.GroupStatus;

/**
 * When each step of a recovery was seen first, so that one that takes too long can be told from the
 * others. Real time. Confined to one thread, which looks now and then: a step is seen no more
 * exactly than that.
 */
public final class RecoverySteps {

  /** Whether a step has been taken. */
  @FunctionalInterface
  public interface Step {
    /** Answers soon, and changes nothing: a call to what is dead would bring it back. */
    boolean isTaken() throws IOException;
  }

  private final Map<String, Step> open = new LinkedHashMap<>();
  private final Map<String, Duration> taken = new LinkedHashMap<>();
  private final LongSupplier nanos;
  private final long begin;

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
  public static RecoverySteps of(FieldRobot robot, String group, long process) {
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
  public RecoverySteps step(String name, Step step) {
    open.put(name, step);
    return this;
  }

  /** Looks which steps have been taken since the last look. */
  public void look() throws IOException {
    for (Map.Entry<String, Step> each : List.copyOf(open.entrySet())) {
      if (each.getValue().isTaken()) {
        open.remove(each.getKey());
        taken.put(each.getKey(), Duration.ofNanos(nanos.getAsLong() - begin));
      }
    }
  }

  /**
   * The steps in the order they were seen, then those that were not: {@code noticed 0.1 s, ...}.
   */
  @Override
  public String toString() {
    StringJoiner all = new StringJoiner(", ");
    taken.forEach(
        (name, after) ->
            all.add(String.format(Locale.ROOT, "%s %.1f s", name, after.toNanos() / 1e9)));
    open.keySet().forEach(name -> all.add(name + " not seen"));
    return all.toString();
  }
}
