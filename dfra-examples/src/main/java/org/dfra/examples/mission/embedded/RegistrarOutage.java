package org.dfra.examples.mission.embedded;

import java.rmi.RemoteException;
import java.time.Instant;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.concurrent.Callable;
import net.jini.core.entry.Entry;
import net.jini.core.lookup.ServiceItem;
import net.jini.core.lookup.ServiceTemplate;
import org.dfra.examples.mission.monitor.FaultInjectionContext;
import org.dfra.examples.mission.monitor.Outage;
import org.dfra.examples.mission.monitor.SearchingRobot;
import org.dfra.module.Module;
import org.dfra.report.measurement.MeasuredValue;
import org.dfra.river.bootstrap.EmbeddedRegistrar;
import org.dfra.river.bootstrap.EmbeddedRobot;
import org.dfra.river.entry.ModuleEntry;

/**
 * A robot's registrar is stopped: clients that know no other registrar cannot discover the robot.
 * Later an empty registrar is started at the same port, and all modules register again by
 * themselves.
 */
final class RegistrarOutage extends Outage<EmbeddedRobot, EmbeddedRegistrar> {

  /** Target until the modules are listed again, real seconds. */
  private static final double MOST = 5;

  private Set<String> listed = Set.of(); // known once it is stopped

  /**
   * @param robot its index, from 0
   * @param from share of its search after which its registrar is stopped
   * @param to share after which it is restarted; {@link #NEVER} for a permanent outage
   */
  RegistrarOutage(int robot, double from, double to) {
    super(robot, from, to, "registrar operator");
  }

  @Override
  protected Callable<?> prepareStop(SearchingRobot<EmbeddedRobot> victim) throws Exception {
    listed = RegistrarContents.query(victim.robot()).keySet();
    return () -> {
      victim.robot().registrar().close();
      return victim;
    };
  }

  @Override
  protected void reportStop(
      FaultInjectionContext<EmbeddedRobot> now, SearchingRobot<EmbeddedRobot> victim) {
    now.recordEvent(
        stopped(),
        victim,
        "its registrar is ended, which listed its %d modules; it continues to drive",
        listed.size());
  }

  @Override
  protected EmbeddedRegistrar restart(SearchingRobot<EmbeddedRobot> victim) throws Exception {
    return victim.robot().registrar().start();
  }

  @Override
  protected void reportEnd(
      FaultInjectionContext<EmbeddedRobot> now, SearchingRobot<EmbeddedRobot> victim) {
    Instant end = now.clock().instant();
    now.recordEvent(
        end,
        victim,
        "its search has ended; the last %.0f s of it were without its registrar",
        FaultInjectionContext.seconds(stopped(), end));
  }

  @Override
  protected boolean reportRecovery(
      FaultInjectionContext<EmbeddedRobot> now,
      SearchingRobot<EmbeddedRobot> victim,
      EmbeddedRegistrar registrar)
      throws Exception {
    Set<String> again = RegistrarContents.query(victim.robot()).keySet();
    if (again.size() < listed.size()) {
      return false; // some are still registering
    }
    Instant back = now.clock().instant();
    now.recordEvent(
        back,
        victim,
        "its registrar is back and lists its %d modules again; it was down for %.0f s, in which"
            + " the robot searched %.0f %% of its region",
        again.size(),
        FaultInjectionContext.seconds(stopped(), restarted()),
        percentSearchedSince(victim));
    now.figure(
        "registrar back to all modules listed again",
        FaultInjectionContext.seconds(restarted(), back) / now.speed(),
        MOST);
    now.measurements()
        .add(
            new MeasuredValue(
                "registrar back: modules that are listed under another service ID",
                again.stream().filter(each -> !listed.contains(each)).count(),
                0,
                ""));
    return true;
  }

  /** The modules of a robot that a registrar lists. */
  static final class RegistrarContents {

    private RegistrarContents() {}

    /** Proxies of the robot's modules in its own registrar, by their service IDs. */
    static Map<String, Module> query(EmbeddedRobot robot) throws RemoteException {
      Map<String, Module> modules = new TreeMap<>();
      ModuleEntry own = new ModuleEntry();
      own.robot = robot.name();
      ServiceTemplate all = new ServiceTemplate(null, null, new Entry[] {own});
      for (ServiceItem each : robot.registrar().registrar().lookup(all, Integer.MAX_VALUE).items) {
        if (each.service instanceof Module module) { // null if its class cannot be loaded
          modules.put(each.serviceID.toString(), module);
        }
      }
      return modules;
    }
  }
}
