package org.dfra.examples.mission.process;

import java.util.Map;
import java.util.TreeMap;
import java.util.concurrent.Callable;
import org.dfra.examples.harness.DemoRobot;
import org.dfra.examples.mission.monitor.FaultInjectionContext;
import org.dfra.examples.mission.monitor.MissionMonitor.InjectedFault;
import org.dfra.examples.mission.monitor.Outage;
import org.dfra.examples.mission.monitor.SearchingRobot;
import org.dfra.report.measurement.MeasuredValue;
import org.dfra.river.phoenix.GroupStatus;

/**
 * A robot's registrar and its phoenix are killed: it is found through another robot's registrar
 * only, and no process restarts its groups. Later phoenix is restarted and adopts the running
 * groups.
 */
final class PhoenixOutage extends Outage<DemoRobot, ProcessHandle> {

  private static final String LOOKUP = "lookup";

  private final InjectedFault<DemoRobot> before;

  // known once it is down
  private Map<String, Long> groups = Map.of();
  private volatile long registrar; // its process; the operator's thread reads it

  /**
   * @param robot its index, from 0
   * @param from share of its search after which phoenix is killed
   * @param to share after which its phoenix is restarted; {@link #NEVER} for a permanent outage
   * @param before a fault that comes first
   */
  PhoenixOutage(int robot, double from, double to, InjectedFault<DemoRobot> before) {
    super(robot, from, to, "phoenix operator");
    this.before = before;
  }

  @Override
  protected boolean isStopAllowed() {
    return before.isOver();
  }

  @Override
  protected Callable<?> prepareStop(SearchingRobot<DemoRobot> victim) throws Exception {
    groups = processes(victim);
    registrar = victim.robot().process(LOOKUP);
    return () -> {
      victim.robot().host().killPhoenix();
      victim.robot().host().kill(registrar);
      return victim;
    };
  }

  @Override
  protected void reportStop(
      FaultInjectionContext<DemoRobot> now, SearchingRobot<DemoRobot> victim) {
    now.recordEvent(
        stopped(),
        victim,
        "its phoenix and its registrar are killed (process %d); it continues to drive",
        registrar);
  }

  @Override
  protected ProcessHandle restart(SearchingRobot<DemoRobot> victim) throws Exception {
    return victim.robot().host().startPhoenix();
  }

  @Override
  protected boolean reportRecovery(
      FaultInjectionContext<DemoRobot> now, SearchingRobot<DemoRobot> victim, ProcessHandle process)
      throws Exception {
    if (victim.robot().process(LOOKUP) <= 0) {
      return false; // its registrar is restarting
    }
    Map<String, Long> adopted = processes(victim);
    long others =
        groups.entrySet().stream()
            .filter(each -> !each.getKey().endsWith("." + LOOKUP))
            .filter(each -> !each.getValue().equals(adopted.get(each.getKey())))
            .count();
    now.recordEvent(
        now.clock().instant(),
        victim,
        "phoenix runs again (process %d) and has adopted its %d running groups; it was down for"
            + " %.0f s, in which the robot searched %.0f %% of its region",
        process.pid(),
        groups.size() - 1,
        FaultInjectionContext.seconds(stopped(), now.clock().instant()),
        percentSearchedSince(victim));
    now.measurements()
        .add(
            new MeasuredValue(
                "phoenix back: living groups that have another process", others, 0, ""));
    return true;
  }

  private static Map<String, Long> processes(SearchingRobot<DemoRobot> victim) throws Exception {
    Map<String, Long> processes = new TreeMap<>();
    for (GroupStatus each : victim.robot().host().groups()) {
      processes.put(each.name(), each.pid());
    }
    return processes;
  }
}
