package org.dfra.examples.mission.embedded;

import java.rmi.RemoteException;
import java.time.Instant;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import net.jini.core.entry.Entry;
import net.jini.core.lookup.ServiceItem;
import net.jini.core.lookup.ServiceTemplate;
import org.dfra.examples.mission.monitor.MissionContext;
import org.dfra.examples.mission.monitor.MissionMonitor.InjectedFault;
import org.dfra.examples.mission.monitor.SearchingRobot;
import org.dfra.module.Module;
import org.dfra.report.measurement.MeasuredValue;
import org.dfra.river.bootstrap.EmbeddedRobot;
import org.dfra.river.entry.ModuleEntry;
import org.jspecify.annotations.Nullable;

/**
 * A robot's registrar is stopped: clients that know no other registrar cannot discover the robot.
 * The robot continues. Later an empty registrar is started at the same port, and all modules
 * register again by themselves.
 *
 * <pre>
 *   PENDING --share done--&gt; STOPPING --stopped--&gt; DOWN --more done--&gt; RECOVERING
 *                                                       |                     |
 *                            permanent, search ended    v                     v all listed
 *                                                      DONE                  DONE
 * </pre>
 */
final class RegistrarOutage implements InjectedFault<EmbeddedRobot> {

  /** It is not restarted. */
  static final double NEVER = Double.POSITIVE_INFINITY;

  /** Target until the modules are listed again, real seconds. */
  private static final double MOST = 5;

  private enum State {
    /** Waits until the robot has done a share of its search. */
    PENDING,
    /** Waits until the registrar has stopped. */
    STOPPING,
    /** Waits until the robot has done more. */
    DOWN,
    /** Waits until the registrar lists all modules again. */
    RECOVERING,
    /** The fault has ended, or will not occur. */
    DONE
  }

  private final int robot;
  private final double from;
  private final double to;
  private final ExecutorService operator =
      Executors.newSingleThreadExecutor(task -> new Thread(task, "registrar operator"));
  private State state = State.PENDING;

  // known once it is stopped
  private Set<String> listed = Set.of();
  private double done;
  private Instant lost = Instant.MIN;
  private Instant returned = Instant.MIN;
  private @Nullable Future<?> work; // the operator's thread

  /**
   * @param robot its index, from 0
   * @param from share of its search after which its registrar is stopped
   * @param to share after which it is restarted; {@link #NEVER} for a permanent outage
   */
  RegistrarOutage(int robot, double from, double to) {
    this.robot = robot;
    this.from = from;
    this.to = to;
  }

  @Override
  public void update(MissionContext<EmbeddedRobot> now) throws Exception {
    SearchingRobot<EmbeddedRobot> victim = now.robots().get(robot);
    double share = victim.subscriptions().latestStatus().completion();
    boolean hasEnded = victim.hasEnded();
    switch (state) {
      case PENDING -> {
        if (hasEnded) {
          state = State.DONE;
        } else if (share >= from) {
          stopRegistrar(now, victim);
        }
      }
      case STOPPING -> {
        if (isWorkDone()) {
          state = State.DOWN;
        }
      }
      case DOWN -> {
        if (hasEnded && to == NEVER) {
          reportEnd(now, victim);
        } else if (hasEnded || share >= to) {
          returned = now.clock().instant();
          work = operator.submit(() -> victim.robot().registrar().start());
          state = State.RECOVERING;
        }
      }
      case RECOVERING -> {
        if (isWorkDone()) {
          checkAllListed(now, victim);
        }
      }
      default -> {}
    }
  }

  private void stopRegistrar(
      MissionContext<EmbeddedRobot> now, SearchingRobot<EmbeddedRobot> victim) throws Exception {
    listed = RegistrarContents.query(victim.robot()).keySet();
    done = victim.subscriptions().latestStatus().completion();
    lost = now.clock().instant();
    work =
        operator.submit(
            () -> {
              victim.robot().registrar().close();
              return null;
            });
    now.recordEvent(
        lost,
        victim,
        "its registrar is ended, which listed its %d modules; it continues to drive",
        listed.size());
    state = State.STOPPING;
  }

  /** Whether the operator's task is complete; rethrows its exception. */
  private boolean isWorkDone() throws Exception {
    Future<?> known = work;
    if (known == null || !known.isDone()) {
      return false;
    }
    Object unused = known.get();
    return true;
  }

  private void reportEnd(MissionContext<EmbeddedRobot> now, SearchingRobot<EmbeddedRobot> victim) {
    Instant end = now.clock().instant();
    now.recordEvent(
        end,
        victim,
        "its search has ended; the last %.0f s of it were without its registrar",
        MissionContext.seconds(lost, end));
    state = State.DONE;
  }

  private void checkAllListed(
      MissionContext<EmbeddedRobot> now, SearchingRobot<EmbeddedRobot> victim) throws Exception {
    Set<String> again = RegistrarContents.query(victim.robot()).keySet();
    if (again.size() < listed.size()) {
      return; // some are still registering
    }
    Instant back = now.clock().instant();
    now.recordEvent(
        back,
        victim,
        "its registrar is back and lists its %d modules again; it was down for %.0f s, in which"
            + " the robot searched %.0f %% of its region",
        again.size(),
        MissionContext.seconds(lost, returned),
        100 * (victim.subscriptions().latestStatus().completion() - done));
    now.figure(
        "registrar back to all modules listed again",
        MissionContext.seconds(returned, back) / now.speed(),
        MOST);
    now.measurements()
        .add(
            new MeasuredValue(
                "registrar back: modules that are listed under another service ID",
                again.stream().filter(each -> !listed.contains(each)).count(),
                0,
                ""));
    state = State.DONE;
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
    operator.shutdownNow();
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
