package org.dfra.cli.doctor;

import java.io.IOException;
import java.rmi.RemoteException;
import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.concurrent.Callable;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import net.jini.admin.Administrable;
import net.jini.core.discovery.LookupLocator;
import net.jini.core.lookup.ServiceRegistrar;
import org.dfra.cli.doctor.ClockCheck.NtpClockOffset;
import org.dfra.cli.doctor.ClockCheck.RobotClock;
import org.dfra.cli.doctor.RegistrarCheck.Survey;
import org.dfra.cli.doctor.RegistrarCheck.SurveyedRegistrar;
import org.dfra.cli.team.DuplicateRobotNames;
import org.dfra.cli.team.TeamOptions;
import org.dfra.cli.team.UnreadyModule;
import org.dfra.directory.ModuleListing;
import org.dfra.directory.ModuleQuery;
import org.dfra.module.Module;
import org.dfra.persona.EmergencyStopAttributes;
import org.dfra.river.bootstrap.HostAddress;
import org.dfra.river.lookup.JiniModuleDirectory;
import org.dfra.river.remote.ModuleAdmin;
import org.jspecify.annotations.Nullable;

/**
 * A survey of the team: its lookup services, and its robots' clocks.
 *
 * <p>The timeout for one peer is 0.8 s, or a tenth of the requested total timeout if that is
 * longer. All peers are queried in parallel.
 */
final class TeamSurvey
    implements RegistrarCheck.Search,
        ModuleCheck.ModuleProbe,
        ClockCheck.ClockProbe,
        StopCheck.StopProbe,
        NameCheck.NameProbe,
        AutoCloseable {

  /** Minimum timeout for one peer. */
  private static final Duration LEAST_DEADLINE = Duration.ofMillis(800);

  /** The first answer is slow, since it opens connections; more requests change little. */
  private static final int QUESTIONS = 8;

  private final JiniModuleDirectory directory;
  private final Duration patience;
  private final Duration deadline;
  private final ExecutorService askers =
      Executors.newCachedThreadPool(
          task -> {
            Thread thread = new Thread(task, "dfra-doctor-asks");
            thread.setDaemon(true);
            return thread;
          });

  private TeamSurvey(JiniModuleDirectory directory, Duration patience) {
    this.directory = directory;
    this.patience = patience;
    this.deadline = deadline(patience);
  }

  /** The timeout for one peer, see above. */
  static Duration deadline(Duration patience) {
    Duration share = patience.dividedBy(10);
    return share.compareTo(LEAST_DEADLINE) > 0 ? share : LEAST_DEADLINE;
  }

  /** Starts the discovery. */
  static TeamSurvey open(TeamOptions team) throws IOException {
    return new TeamSurvey(team.directory(), team.timeout());
  }

  @Override
  public Survey survey() throws InterruptedException {
    List<String> silent = directory.awaitFirstRead(patience);
    Map<ServiceRegistrar, Future<SurveyedRegistrar>> asked = new LinkedHashMap<>();
    for (ServiceRegistrar each : directory.lookupServices()) {
      asked.put(each, askers.submit(() -> seen(each)));
    }
    List<SurveyedRegistrar> seen = new ArrayList<>();
    for (Map.Entry<ServiceRegistrar, Future<SurveyedRegistrar>> each : asked.entrySet()) {
      String name = each.getKey().toString();
      seen.add(
          answer(each.getValue())
              .orElseGet(() -> new SurveyedRegistrar(name, List.of(), false, null)));
    }
    return new Survey(seen, silent);
  }

  private static SurveyedRegistrar seen(ServiceRegistrar registrar) throws RemoteException {
    List<String> groups = Arrays.asList(registrar.getGroups());
    long asked = System.nanoTime();
    LookupLocator locator = registrar.getLocator();
    return new SurveyedRegistrar(
        "jini://" + locator.getHost() + ":" + locator.getPort(),
        groups,
        HostAddress.isLoopback(locator.getHost()),
        Duration.ofNanos(System.nanoTime() - asked));
  }

  @Override
  public ModuleCheck.UnusableModules unusable() throws InterruptedException {
    directory.awaitFirstRead(patience);
    return new ModuleCheck.UnusableModules(
        UnreadyModule.query(directory.find(ModuleQuery.of(Module.class)), deadline),
        directory.unreadableModules(),
        directory.conflicts());
  }

  @Override
  public List<RobotClock> measure() throws InterruptedException {
    directory.awaitFirstRead(patience);
    List<ModuleListing<Module>> all = directory.find(ModuleQuery.of(Module.class));
    Map<String, List<String>> namesakes = DuplicateRobotNames.of(all);
    Map<String, List<Module>> robots = new TreeMap<>();
    for (ModuleListing<Module> each : all) {
      if (!each.stale() && !each.robot().isEmpty()) {
        String robot =
            namesakes.containsKey(each.robot()) ? each.robot() + "@" + each.host() : each.robot();
        robots.computeIfAbsent(robot, name -> new ArrayList<>()).add(each.module());
      }
    }
    Map<String, Future<NtpClockOffset>> asked = new TreeMap<>();
    robots.forEach((robot, modules) -> asked.put(robot, askers.submit(() -> offset(modules))));
    List<RobotClock> measured = new ArrayList<>();
    for (Map.Entry<String, Future<NtpClockOffset>> each : asked.entrySet()) {
      measured.add(new RobotClock(each.getKey(), answer(each.getValue()).orElse(null)));
    }
    return measured;
  }

  @Override
  public List<StopCheck.StoppedEffector> stopped() throws InterruptedException {
    directory.awaitFirstRead(patience);
    List<StopCheck.StoppedEffector> stopped = new ArrayList<>();
    for (ModuleListing<Module> each : directory.find(ModuleQuery.of(Module.class))) {
      each.attributes(EmergencyStopAttributes.class)
          .filter(EmergencyStopAttributes::latched)
          .map(stop -> new StopCheck.StoppedEffector(each.robot(), each.path(), stop))
          .ifPresent(stopped::add);
    }
    return stopped;
  }

  @Override
  public Map<String, List<String>> hostsByDuplicateName() throws InterruptedException {
    directory.awaitFirstRead(patience);
    return DuplicateRobotNames.of(directory.find(ModuleQuery.of(Module.class)));
  }

  /** By the first of a robot's modules that answers. */
  static NtpClockOffset offset(List<Module> modules) throws Exception {
    @Nullable Exception failure = null;
    for (Module module : modules) {
      try {
        if (module instanceof Administrable administrable
            && administrable.getAdmin() instanceof ModuleAdmin admin) {
          Callable<Instant> clock = admin::hostTime;
          return NtpClockOffset.measure(QUESTIONS, clock, InstantSource.system());
        }
      } catch (RemoteException | RuntimeException e) { // also an exception of a foreign proxy
        failure = e;
      }
    }
    throw failure == null ? new RemoteException("no module has an administration") : failure;
  }

  /** A peer's answer; empty if it failed or timed out. */
  private <T> Optional<T> answer(Future<T> asked) throws InterruptedException {
    try {
      return Optional.of(asked.get(deadline.toMillis(), TimeUnit.MILLISECONDS));
    } catch (ExecutionException | TimeoutException e) {
      asked.cancel(true);
      return Optional.empty();
    }
  }

  @Override
  public void close() {
    askers.shutdownNow();
    directory.close();
  }
}
