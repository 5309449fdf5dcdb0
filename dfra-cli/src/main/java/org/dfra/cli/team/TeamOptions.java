package org.dfra.cli.team;

import java.io.IOException;
import java.net.MalformedURLException;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.function.Consumer;
import java.util.function.UnaryOperator;
import net.jini.core.discovery.LookupLocator;
import org.dfra.cli.team.PhoenixOptions.StateOption;
import org.dfra.core.config.ConfigurationException;
import org.dfra.core.config.RobotDescription;
import org.dfra.report.terminal.CommandOutput;
import org.dfra.river.bootstrap.HostAddress;
import org.dfra.river.bootstrap.PhoenixProcess;
import org.dfra.river.bootstrap.RobotDescriptionStore;
import org.dfra.river.call.CallbackHost;
import org.dfra.river.lookup.EffectorSearch;
import org.dfra.river.lookup.JiniModuleDirectory;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;
import picocli.CommandLine.Spec.Target;

/**
 * The options for the discovery of the team's lookup services. A picocli mix-in.
 *
 * <p>It queries the registrars of the robots that were brought up on this host, those at the
 * locators, and by multicast those of the discovery groups.
 */
public final class TeamOptions {

  /** The default discovery group. */
  static final String DEFAULT_TEAM = "field";

  /** The default timeout, seconds. */
  private static final String DEFAULT_WAIT = "2";

  @Option(
      names = "--team",
      paramLabel = "GROUPS",
      description =
          "Discovery groups to search by multicast, separated by commas; empty for none (default:"
              + " DFRA_TEAM, or field).")
  private @Nullable String team;

  @Option(
      names = "--locator",
      paramLabel = "HOST:PORT[,...]",
      hideParamSyntax = true,
      split = ",",
      description = "Registrars to contact by unicast (default: those of DFRA_LOCATORS).")
  private String @Nullable [] locators;

  @Option(
      names = "--host",
      paramLabel = "ADDRESS",
      description =
          "Address at which registrars reach this computer (default: DFRA_HOST, or auto).")
  private @Nullable String host;

  @Option(
      names = "--wait",
      paramLabel = "SECONDS",
      description = "How long to wait for answers (default: DFRA_WAIT, or 2).")
  private @Nullable Double wait;

  @Mixin
  @SuppressWarnings("NullAway.Init") // set by picocli before the call
  private StateOption state;

  @Mixin
  @SuppressWarnings("NullAway.Init") // set by picocli before the call
  private CommandOutput answer;

  @Spec(Target.MIXEE)
  @SuppressWarnings("NullAway.Init") // set by picocli before the call
  private CommandSpec spec;

  /** The output of the command. */
  public CommandOutput answer() {
    return answer;
  }

  /** Starts the discovery. */
  public TeamDirectory open() throws IOException {
    return new TeamDirectory(directory(), timeout(), answer, whatIsAsked(groups(), locators()));
  }

  /** A directory of the selected lookup services. */
  public JiniModuleDirectory directory() throws IOException {
    timeout(); // rejected before any discovery
    return new JiniModuleDirectory(here(), groups(), new ArrayList<>(locators()));
  }

  /**
   * Searches the same lookup services for effectors, for an emergency: invalid settings are
   * reported and ignored. It starts without a name service: names of this computer are taken as
   * they are.
   *
   * @param robots whose effectors are selected, by name; all if empty
   * @param listener is notified of the effectors found
   * @param unasked receives a sentence about each named lookup service that cannot be queried
   */
  public EffectorSearch emergencySearch(
      List<String> robots, EffectorSearch.Listener listener, Consumer<String> unasked)
      throws IOException {
    Set<String> locators = new LinkedHashSet<>();
    List<String> known = new ArrayList<>();
    try {
      for (RobotDescription robot : knownRobots()) {
        known.add(robot.name());
        try {
          addLocator(robot, locators, HostAddress::resolveWithoutLookup);
        } catch (ConfigurationException e) { // e.g. no longer an address of this host
          answer.note(
              "the lookup service of robot " + robot.name() + " is not asked: " + e.getMessage());
        }
      }
    } catch (IOException | ConfigurationException e) {
      answer.note("this host's lookup services are not known: " + e.getMessage());
    }
    for (String named : namedLocators()) {
      try {
        LookupLocator unused = new LookupLocator(named);
        locators.add(named);
      } catch (MalformedURLException e) {
        unasked.accept("the lookup service " + named + " cannot be asked: " + e.getMessage());
      }
    }
    try {
      String unused = HostAddress.isName(hostSetting()) ? hostSetting() : here();
    } catch (ConfigurationException e) {
      answer.note(e.getMessage() + "; one is chosen now");
    }
    return new EffectorSearch(groups(), new ArrayList<>(locators), robots, known, listener);
  }

  /** As {@link #timeout}, for an emergency: an invalid setting is reported and ignored. */
  public Duration emergencyTimeout() {
    try {
      return timeout();
    } catch (ParameterException e) {
      answer.note(e.getMessage() + "; it waits " + DEFAULT_WAIT + " s");
      return seconds(Double.parseDouble(DEFAULT_WAIT), DEFAULT_WAIT);
    }
  }

  private Set<String> locators() throws IOException {
    Set<String> all = new LinkedHashSet<>();
    for (RobotDescription robot : knownRobots()) {
      addLocator(robot, all, HostAddress::resolve);
    }
    all.addAll(namedLocators());
    return all;
  }

  private static void addLocator(
      RobotDescription robot, Set<String> all, UnaryOperator<String> resolve) {
    robot
        .registrar()
        .filter(registrar -> registrar.port() != 0)
        .ifPresent(
            registrar -> all.add("jini://" + resolve.apply(robot.host()) + ":" + registrar.port()));
  }

  /** The address for calls from modules and lookup services to this computer. */
  private String here() {
    String wanted = hostSetting();
    String here = HostAddress.resolve(wanted);
    if (!wanted.equals(HostAddress.AUTO)) {
      System.setProperty(CallbackHost.PROPERTY, here); // modules call listeners at this address too
    }
    return here;
  }

  /** The timeout for answers. */
  public Duration timeout() {
    if (wait != null) {
      return seconds(wait, "--wait=" + wait);
    }
    String variable = either(null, "DFRA_WAIT", DEFAULT_WAIT);
    try {
      return seconds(Double.parseDouble(variable), "DFRA_WAIT=" + variable);
    } catch (NumberFormatException e) {
      throw noDuration("DFRA_WAIT=" + variable);
    }
  }

  private Duration seconds(double seconds, String source) {
    if (!(seconds >= 0 && seconds <= 3600)) {
      throw noDuration(source);
    }
    return Duration.ofNanos((long) (seconds * 1e9));
  }

  private ParameterException noDuration(String source) {
    return new ParameterException(
        spec.commandLine(), source + " is not a number of seconds from 0 to 3600");
  }

  /** The discovery groups for multicast; none if empty. */
  public List<String> groups() {
    return words(either(team, "DFRA_TEAM", DEFAULT_TEAM));
  }

  /** The configured address or name of this computer, or {@code auto}. */
  public String hostSetting() {
    return either(host, "DFRA_HOST", HostAddress.AUTO);
  }

  /** Phoenix's state folder on this host. */
  public Path state() {
    return state.folder();
  }

  /** The phoenix of this host that was last started, whether it runs or not. */
  public PhoenixProcess phoenix() throws IOException {
    return PhoenixOptions.lastStarted(state(), PhoenixOptions.REGISTRY_PORT);
  }

  /** The robots that were brought up on this host. */
  public List<RobotDescription> knownRobots() throws IOException {
    return new RobotDescriptionStore(state()).all();
  }

  /** The registrars named by option or variable, as {@code jini://host:port}. */
  public List<String> namedLocators() {
    List<String> named =
        words(locators == null ? either(null, "DFRA_LOCATORS", "") : String.join(",", locators));
    return named.stream()
        .map(each -> each.startsWith("jini://") ? each : "jini://" + each)
        .toList();
  }

  private static String whatIsAsked(List<String> groups, Set<String> locators) {
    List<String> asked = new ArrayList<>();
    if (!groups.isEmpty()) {
      asked.add("group " + String.join(", ", groups) + " by multicast");
    }
    asked.addAll(locators);
    return asked.isEmpty() ? "nobody" : String.join(" and ", asked);
  }

  private static String either(@Nullable String option, String variable, String otherwise) {
    if (option != null) {
      return option.strip();
    }
    String value = System.getenv(variable);
    return value == null || value.isBlank() ? otherwise : value.strip();
  }

  private static List<String> words(String list) {
    return Arrays.stream(list.split(",", -1))
        .map(String::strip)
        .filter(word -> !word.isEmpty())
        .toList();
  }
}
