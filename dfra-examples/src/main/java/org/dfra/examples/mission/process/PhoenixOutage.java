package org.dfra.examples.mission.process;

import java.time.Instant;
import java.util.Map;
import java.util.TreeMap;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import org.dfra.examples.harness.DemoRobot;
import org.dfra.examples.mission.monitor.MissionContext;
import org.dfra.examples.mission.monitor.MissionMonitor.InjectedFault;
import org.dfra.examples.mission.monitor.SearchingRobot;
import org.dfra.report.measurement.MeasuredValue;
import org.dfra.river.phoenix.GroupStatus;
import org.jspecify.annotations.Nullable;

/**
 * A robot's registrar and its phoenix are killed: it is found through another robot's registrar
 * only, and no process restarts its groups. The robot continues. Later phoenix is restarted and
 * adopts the running groups.
 *
 * <pre>
 *   PENDING --share done--&gt; DOWN --more done--&gt; RECOVERING
 *                              |                     |
 *   permanent, search ended    v                     v phoenix and registrar answer
 *                             DONE                  DONE
 * </pre>
 */
final class PhoenixOutage implements InjectedFault<DemoRobot> {

  /** Phoenix is not restarted. */
  static final double NEVER = Double.POSITIVE_INFINITY;

  private static final String LOOKUP = "lookup";

  private enum State {
    /** Waits until the robot has done a share of its search. */
    PENDING,
    /** Waits until it has done more. */
    DOWN,
    /** Waits until phoenix has started. */
    RECOVERING,
    /** The fault has ended, or will not occur. */
    DONE
  }

  private final int robot;
  private final double from;
  private final double to;
  private final InjectedFault<DemoRobot> before;
  private final ExecutorService starter =
      Executors.newSingleThreadExecutor(task -> new Thread(task, "phoenix starter"));
  private State state = State.PENDING;

  // known once it is down
  private Map<String, Long> groups = Map.of();
  private double done;
  private Instant cut = Instant.MIN;
  private @Nullable Future<ProcessHandle> phoenix;

  /**
   * @param robot its index, from 0
   * @param from share of its search after which phoenix is killed
   * @param to share after which its phoenix is restarted; {@link #NEVER} for a permanent outage
   * @param before a fault that comes first
   */
  PhoenixOutage(int robot, double from, double to, InjectedFault<DemoRobot> before) {
    this.robot = robot;
    this.before = before;
    this.from = from;
    this.to = to;
  }

  @Override
  public void update(MissionContext<DemoRobot> now) throws Exception {
    SearchingRobot<DemoRobot> victim = now.robots().get(robot);
    double share = victim.subscriptions().latestStatus().completion();
    boolean hasEnded = victim.hasEnded();
    switch (state) {
      case PENDING -> {
        if (hasEnded) {
          state = State.DONE;
        } else if (share >= from && before.isOver()) {
          cut(now, victim);
        }
      }
      case DOWN -> {
        if (hasEnded && to == NEVER) {
          state = State.DONE;
        } else if (hasEnded || share >= to) {
          phoenix = starter.submit(() -> victim.robot().host().startPhoenix());
          state = State.RECOVERING;
        }
      }
      case RECOVERING -> {
        if (phoenix != null && phoenix.isDone()) {
          back(now, victim, phoenix.get());
        }
      }
      default -> {}
    }
  }

  private void cut(MissionContext<DemoRobot> now, SearchingRobot<DemoRobot> victim)
      throws Exception {
    groups = processes(victim);
    long registrar = victim.robot().process(LOOKUP);
    cut = now.clock().instant();
    done = victim.subscriptions().latestStatus().completion();
    victim.robot().host().killPhoenix();
    victim.robot().host().kill(registrar);
    now.recordEvent(
        cut,
        victim,
        "its phoenix and its registrar are killed (process %d); it continues to drive",
        registrar);
    state = State.DOWN;
  }

  private void back(
      MissionContext<DemoRobot> now, SearchingRobot<DemoRobot> victim, ProcessHandle process)
      throws Exception {
    if (victim.robot().process(LOOKUP) <= 0) {
      return; // its registrar is restarting
    }
    Map<String, Long> living = processes(victim);
    long others =
        groups.entrySet().stream()
            .filter(each -> !each.getKey().endsWith("." + LOOKUP))
            .filter(each -> !each.getValue().equals(living.get(each.getKey())))
            .count();
    now.recordEvent(
        now.clock().instant(),
        victim,
        "phoenix runs again (process %d) and has adopted its %d running groups; it was down for"
            + " %.0f s, in which the robot searched %.0f %% of its region",
        process.pid(),
        groups.size() - 1,
        MissionContext.seconds(cut, now.clock().instant()),
        100 * (victim.subscriptions().latestStatus().completion() - done));
    now.measurements()
        .add(
            new MeasuredValue(
                "phoenix back: living groups that have another process", others, 0, ""));
    state = State.DONE;
  }

  private static Map<String, Long> processes(SearchingRobot<DemoRobot> victim) throws Exception {
    Map<String, Long> processes = new TreeMap<>();
    for (GroupStatus each : victim.robot().host().groups()) {
      processes.put(each.name(), each.pid());
    }
    return processes;
  }

  @Override
  public boolean hasStarted() {
    return state != State.PENDING;
  }

  @Override
  public boolean isOver() {
    return state == State.DONE;
  }

  @Override
  public void close() {
    starter.shutdownNow();
  }
}
