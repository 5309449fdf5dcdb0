package org.dfra.cli.stop;

import java.io.IOException;
import java.net.InetAddress;
import java.nio.file.Files;
import java.nio.file.Path;
import java.rmi.RemoteException;
import java.rmi.activation.ActivationException;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.Collections;
import java.util.Comparator;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.UUID;
import java.util.concurrent.Callable;
import java.util.stream.Collectors;
import org.dfra.cli.stop.Outcome.Result;
import org.dfra.cli.stop.PhoenixAddresses.Address;
import org.dfra.cli.stop.PhoenixAddresses.Origin;
import org.dfra.cli.team.TeamOptions;
import org.dfra.core.config.ConfigurationException;
import org.dfra.core.config.RobotDescription;
import org.dfra.core.host.CommandName;
import org.dfra.flow.effector.Effector;
import org.dfra.flow.effector.EmergencyStopState;
import org.dfra.report.terminal.CommandOutput;
import org.dfra.report.terminal.ExitCode;
import org.dfra.river.bootstrap.HostAddress;
import org.dfra.river.bootstrap.PhoenixInventory;
import org.dfra.river.bootstrap.PhoenixProcess;
import org.dfra.river.call.ConnectionRefusal;
import org.dfra.river.call.PeerAddress;
import org.dfra.river.lookup.EffectorSearch;
import org.dfra.river.lookup.EffectorSearch.ListedEffector;
import org.dfra.river.phoenix.stop.StopLocator;
import org.dfra.river.phoenix.stop.StopReport;
import org.dfra.river.proxy.ModuleProxy;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code ./dfra stop}. */
@Command(
    name = "stop",
    description = "Emergency: stops all effectors at once. They execute no command until released.",
    footer = {
      "",
      "It needs no lease; the commander loses its command lease. A robot of a team refuses",
      "it to strangers, any other robot to nobody. It immediately requests the phoenix of",
      "each known robot to stop all effectors that it runs. It also immediately calls each",
      "effector that it finds, and once more if it does not answer. It repeats the request",
      "to a phoenix that you name, or that this computer knows, until it answers or the time",
      "of --wait is over. The stop stays in force when a process ends. Its release moves",
      "nothing and restores no lease. Exits with 0 only if every known effector was stopped,",
      "with 3 if none is known, with 4 if one did not answer or its phoenix does not confirm",
      "what its proxy reports. It does not replace the robot's own emergency stop."
    })
public final class StopCommand implements Callable<Integer> {

  private static final Logger LOG = LoggerFactory.getLogger(StopCommand.class);

  @Parameters(paramLabel = "ROBOT", arity = "0..*", description = "Robots, by name.")
  private List<String> robots = List.of();

  @Option(names = "--all", description = "Every robot that can be reached.")
  private boolean all;

  @Option(names = "--release", description = "End the emergency stop instead.")
  private boolean release;

  @Option(
      names = "--phoenix",
      paramLabel = "HOST[:PORT][,...]",
      hideParamSyntax = true,
      split = ",",
      description =
          "Instances of phoenix to send the stop request to, in addition to those of this computer"
              + " and of the registrars' computers (default: those of DFRA_PHOENIX).")
  private String @Nullable [] phoenixes;

  @Mixin
  @SuppressWarnings("NullAway.Init") // set by picocli before the call
  private TeamOptions options;

  @Spec
  @SuppressWarnings("NullAway.Init") // set by picocli before the call
  private CommandSpec spec;

  /** The call to an unresponsive phoenix times out this long before its attempt ends. */
  private static final Duration MARGIN = Duration.ofMillis(200);

  private final Set<Outcome> printed = new HashSet<>(); // guarded by itself
  private final long begun = System.nanoTime();
  private String by = "";
  private Duration patience = Duration.ZERO;

  /** An effector in JSON output. */
  record EffectorView(
      String module,
      String result,
      @Nullable String by,
      @Nullable Instant since,
      @Nullable String reason) {}

  /**
   * The JSON output.
   *
   * @param ok whether every known effector was stopped, or released
   * @param effectors outcome for each
   * @param unresponsive named lookup services that did not answer, and robots without effectors
   */
  record Report(boolean ok, List<EffectorView> effectors, List<String> unresponsive) {}

  @Override
  public Integer call() throws Exception {
    if (all != robots.isEmpty()) {
      throw new ParameterException(
          spec.commandLine(), "give the names of robots or --all, not both");
    }
    by = requester(System.getProperty("user.name", "somebody"), options.hostSetting());
    patience = options.emergencyTimeout();
    try (StopDispatcher round =
        new StopDispatcher(
            release ? Result.NOT_RELEASED : Result.NOT_STOPPED,
            StopDispatcher.ATTEMPT_TIMEOUT,
            this::isTimeLeft,
            this::say,
            new StopMerge(by, this::running))) {
      List<String> silent = Collections.synchronizedList(new ArrayList<>());
      PhoenixAddresses addresses = new PhoenixAddresses(options, phoenixes, InetAddress::getByName);
      PhoenixDispatch orders = new PhoenixDispatch(round, addresses);
      if (!release) { // first of all: it needs no lookup service and no foreign class
        addresses.configured(silent::add).forEach(each -> orders.send(each, Origin.NAMED));
        addresses.ofLocators().forEach(each -> orders.send(each, Origin.LOCATOR));
      }
      round.findLocal(() -> callLocal(round));
      try {
        silent.addAll(callListed(round, orders));
      } catch (IOException | RuntimeException e) { // still waits for the calls made so far
        LOG.debug("Lookup services cannot be searched.", e);
        silent.add("no lookup service can be looked for: " + e.getMessage());
      }
      List<Outcome> outcomes =
          round.awaitOutcomes().stream().sorted(Comparator.comparing(Outcome::module)).toList();
      silent.addAll(robotsWithout(outcomes));
      if (!release) {
        addresses.configured(unused -> {}).stream()
            .map(Address::toString)
            .filter(round.confirmations().unresponsive()::contains)
            .map(
                each ->
                    "the phoenix at "
                        + each
                        + " does not answer the order to stop; what it runs may not be stopped")
            .forEach(silent::add);
      }
      return report(outcomes, silent);
    }
  }

  /**
   * The requester, as effectors store it. An invalid address does not prevent the stop, and no name
   * service is used: a name is taken as it is.
   *
   * @param user who enters the command
   * @param host address or name of this computer, or {@code auto}
   */
  static String requester(String user, String host) {
    try {
      return EmergencyStopState.requesterName(
          user + " at " + HostAddress.resolveWithoutLookup(host));
    } catch (ConfigurationException e) { // the search for lookup services reports it
      return EmergencyStopState.requesterName(user);
    }
  }

  private boolean isWanted(String robot) {
    return all || robots.contains(robot);
  }

  private Outcome call(String path, Effector<?> effector) throws RemoteException {
    if (release) {
      return Outcome.ofRelease(path, by, effector.releaseEmergencyStop(by));
    }
    EmergencyStopState now = effector.emergencyStop(by);
    return Outcome.ofStop(path, running(), now);
  }

  /** Whether to send another request to an unresponsive phoenix. */
  private boolean isTimeLeft() {
    return running().compareTo(patience) < 0;
  }

  /** For how long this command has run. */
  private Duration running() {
    return Duration.ofNanos(System.nanoTime() - begun);
  }

  /**
   * On a thread of the dispatcher: phoenix may not answer, and the lookup services must not wait.
   */
  private void callLocal(StopDispatcher round) {
    Path state = options.state();
    List<RobotDescription> known = List.of();
    try {
      known = options.knownRobots();
    } catch (IOException | ConfigurationException e) { // phoenix may know them
      options.answer().note("the XML of this host's robots cannot be read: " + e.getMessage());
    }
    if (known.isEmpty() && !Files.exists(state.resolve("journal"))) {
      return; // no phoenix has ever run here
    }
    try {
      PhoenixProcess phoenix = options.phoenix();
      LocalEffectors effectors =
          new LocalEffectors(() -> PhoenixInventory.services(phoenix), known, this::isWanted);
      for (LocalEffectors.LocalEffector each : effectors.all()) {
        round.callLocal(each.path(), () -> call(each.path(), each.access().reach()));
      }
    } catch (IOException | ActivationException e) {
      if (ConnectionRefusal.isProvenBy(e)) {
        LOG.debug("No phoenix runs here, and no robot is known.", e);
      } else {
        options.answer().note("phoenix of this host cannot be asked: " + e.getMessage());
      }
    }
  }

  /** Sends requests to phoenixes; each is resolved and called on a thread of its own. */
  private final class PhoenixDispatch {

    private final StopDispatcher round;
    private final PhoenixAddresses addresses;
    private final List<String> wanted = all ? List.of() : List.copyOf(robots);

    PhoenixDispatch(StopDispatcher round, PhoenixAddresses addresses) {
      this.round = round;
      this.addresses = addresses;
    }

    /** An invalid address fails on that thread, and does not affect the others. */
    void send(Address address, Origin origin) {
      round.requestPhoenix(address, origin, () -> stop(address, origin));
    }

    private @Nullable StopReport stop(Address address, Origin origin) throws RemoteException {
      Optional<Address> at = addresses.resolve(address, origin);
      if (at.isEmpty()) {
        return null;
      }
      return StopLocator.proxyAt(
              at.get().host(), at.get().port(), StopDispatcher.ATTEMPT_TIMEOUT.minus(MARGIN))
          .emergencyStop(wanted, by);
    }

    /** Before the dispatcher receives the lookup service: its proxies' reports count after that. */
    void sendTo(String registrarHost) {
      addresses.ofRegistrar(registrarHost).ifPresent(each -> send(each, Origin.DISCOVERY));
    }
  }

  /**
   * Calls each proxy as soon as it is read; returns the named lookup services that do not answer.
   */
  private List<String> callListed(StopDispatcher round, PhoenixDispatch orders)
      throws IOException, InterruptedException {
    List<String> unasked = Collections.synchronizedList(new ArrayList<>());
    EffectorSearch.Listener listener =
        new EffectorSearch.Listener() {
          @Override
          public void registrarFound(UUID registrar, String host) {
            if (!release) {
              orders.sendTo(host);
            }
            round.registrarFound(registrar, host);
          }

          @Override
          public void found(ListedEffector effector) {
            callListed(round, effector);
          }
        };
    try (EffectorSearch search =
        options.emergencySearch(all ? List.of() : robots, listener, unasked::add)) {
      List<String> silent = search.awaitRead(patience);
      List<String> named = options.namedLocators();
      List<Outcome> unused =
          round.awaitOutcomes(); // the search stays open during the calls of its proxies
      unasked.addAll(search.unread());
      silent.stream()
          .filter(each -> named.contains(each.replaceAll("/$", "")))
          .map(each -> "no lookup service answers at " + each + "; what it knows of was not called")
          .forEach(unasked::add);
      return List.copyOf(unasked);
    }
  }

  private void callListed(StopDispatcher round, ListedEffector listed) {
    if (isWanted(listed.robot())) {
      @Nullable Effector<?> effector = listed.effector();
      round.callListed(
          listed.id(),
          listed.registrar(),
          effector instanceof ModuleProxy<?> proxy ? PeerAddress.of(proxy.server()) : null,
          listed.path(),
          () -> {
            if (effector == null) {
              throw new IOException(
                  "its proxy cannot be read here; look whether it is of another version of DFRA");
            }
            return call(listed.path(), effector);
          });
    }
  }

  private List<String> robotsWithout(List<Outcome> outcomes) {
    return robots.stream()
        .filter(robot -> outcomes.stream().noneMatch(each -> each.module().startsWith(robot + "/")))
        .map(
            robot ->
                "no effector of robot "
                    + robot
                    + " was found; "
                    + CommandName.current()
                    + " module list shows all")
        .toList();
  }

  /** Prints each outcome once, as soon as it is known. */
  private void say(Outcome outcome) {
    CommandOutput answer = options.answer();
    synchronized (printed) {
      if (!answer.isJson() && printed.add(outcome)) {
        answer.line(outcome, outcome.inWords());
      }
    }
  }

  private int report(List<Outcome> outcomes, List<String> silent) {
    CommandOutput answer = options.answer();
    boolean isEveryOne = outcomes.stream().allMatch(each -> each.result().isWell());
    boolean well = isEveryOne && silent.isEmpty() && !outcomes.isEmpty();
    if (answer.isJson()) {
      answer.details(new Report(well, outcomes.stream().map(StopCommand::view).toList(), silent));
    } else {
      outcomes.forEach(this::say);
      String summary = summary(outcomes, isEveryOne);
      answer.line(summary, summary);
      silent.forEach(answer::note);
    }
    if (well) {
      return ExitCode.SUCCESS;
    } else if (outcomes.isEmpty()) {
      return ExitCode.NOT_FOUND;
    }
    boolean isOnlyHeldUp =
        silent.isEmpty()
            && outcomes.stream()
                .allMatch(
                    each -> each.result().isWell() || each.result() == Result.DRIVER_NOT_STOPPED);
    return isOnlyHeldUp ? ExitCode.FAILED : ExitCode.NO_ANSWER;
  }

  private String summary(List<Outcome> outcomes, boolean isEveryOne) {
    if (outcomes.isEmpty()) {
      return "NOTHING WAS "
          + (release ? "RELEASED" : "STOPPED")
          + ": no effector was found; bring a robot up, name a registrar with --locator, or ask"
          + " "
          + CommandName.current()
          + " doctor.";
    }
    String counts =
        outcomes.stream()
            .collect(Collectors.groupingBy(Outcome::result, TreeMap::new, Collectors.counting()))
            .entrySet()
            .stream()
            .map(each -> each.getValue() + " " + each.getKey().words())
            .collect(Collectors.joining(", "));
    return String.format(
        Locale.ROOT,
        "%d effector%s: %s.%s",
        outcomes.size(),
        outcomes.size() == 1 ? "" : "s",
        counts,
        isEveryOne || release ? "" : " Use the robot's own emergency stop.");
  }

  private static EffectorView view(Outcome outcome) {
    return new EffectorView(
        outcome.module(), outcome.id(), outcome.requester(), outcome.since(), outcome.reason());
  }
}
