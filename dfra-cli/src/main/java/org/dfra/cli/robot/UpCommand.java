package org.dfra.cli.robot;

import java.io.IOException;
import java.nio.file.Path;
import java.rmi.activation.ActivationException;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.Callable;
import org.dfra.cli.robot.StatusCommand.StoppedEffectors;
import org.dfra.cli.team.PhoenixOptions;
import org.dfra.core.config.ConfigurationException;
import org.dfra.core.config.RobotDescription;
import org.dfra.core.config.RobotXml;
import org.dfra.core.host.CommandName;
import org.dfra.core.robot.RobotDryRun;
import org.dfra.report.terminal.CommandOutput;
import org.dfra.report.terminal.ExitCode;
import org.dfra.river.bootstrap.BringUpStep;
import org.dfra.river.bootstrap.HostAddress;
import org.dfra.river.bootstrap.PhoenixProcess;
import org.dfra.river.bootstrap.RobotBootstrap;
import org.dfra.river.loading.RobotCodebase;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** {@code ./dfra up}. */
@Command(
    name = "up",
    description = "Brings robots up on this host: phoenix, their registrars and their modules.",
    footer = {
      "",
      "Starts phoenix if it does not answer; phoenix continues after this command ends. Run",
      "it again to apply changes of the XML: a module whose description has changed is",
      "restarted, a module that is no longer in the XML ends, and the other modules continue.",
      "It prints what it did."
    })
public final class UpCommand implements Callable<Integer> {

  @Parameters(
      paramLabel = "ROBOT.XML",
      arity = "0..*",
      description = "The robots' descriptions (default: that of atrv1, which comes with DFRA).")
  private List<Path> xml =
      List.of(Path.of(System.getProperty("dfra.root", ""), "config", "robots", "atrv1.xml"));

  @Option(
      names = "--open",
      description =
          "Let robots be open to everybody who reaches their address: without it, a robot of a"
              + " computer that has joined no team may have a loopback address only.")
  private boolean open;

  @Mixin
  @SuppressWarnings("NullAway.Init") // set by picocli before the call
  private PhoenixOptions options;

  @Mixin
  @SuppressWarnings("NullAway.Init") // set by picocli before the call
  private CommandOutput answer;

  /**
   * A service that was brought up.
   *
   * @param name {@code robot/module}, or {@code robot/registrar}
   * @param group name of its service group
   * @param stopped whether it is an effector in emergency stop
   * @param step the action, such as {@code started}, {@code kept} or {@code ended}
   * @param detail further information, such as the changes; may be empty
   */
  record BroughtUpService(String name, String group, boolean stopped, String step, String detail) {}

  @Override
  public Integer call() throws Exception {
    PhoenixProcess phoenix = options.lastStarted(); // refuses ports that are none
    List<RobotDescription> robots = robots();
    for (RobotDescription each : robots) {
      RobotSecurity.require(each, open);
    }
    if (!phoenix.isResponding(PhoenixOptions.TIMEOUT)) {
      // Every proxy that reactivates a module contains its address, so other hosts must reach it
      // too.
      Map.Entry<PhoenixProcess, Process> started =
          options.start(HostAddress.resolve(robots.get(0).host()));
      phoenix = started.getKey();
      long pid = started.getValue().pid();
      say("Started phoenix: process " + pid + ", log " + phoenix.log() + ".");
    } else {
      say("Phoenix answers on port " + phoenix.port() + " of " + phoenix.host() + ".");
    }
    options.writePidFile(phoenix);
    List<BroughtUpService> services = new ArrayList<>();
    for (RobotDescription robot : robots) {
      bringUp(new RobotBootstrap(phoenix, robot), robot, phoenix, services);
    }
    ArchiveStart.startIfNeeded(); // now, since it would delay the robot's start
    if (answer.isJson()) {
      answer.details(services);
    } else {
      say("How they are: " + CommandName.current() + " status");
    }
    return ExitCode.SUCCESS;
  }

  private void bringUp(
      RobotBootstrap bootstrap,
      RobotDescription robot,
      PhoenixProcess phoenix,
      List<BroughtUpService> services)
      throws Exception {
    try (DuplicateNameSearch namesakes = DuplicateNameSearch.begin(robot)) {
      Set<String> kept = new HashSet<>();
      List<RobotBootstrap.ServiceReference> unused =
          bootstrap.up(
              step -> {
                if (step.kind() == BringUpStep.Kind.GROUP_STALE) {
                  kept.add(step.name());
                }
                String module = step.name().substring(step.name().indexOf('/') + 1);
                List<String> stops =
                    StoppedEffectors.notices(phoenix.state(), robot.name(), List.of(module));
                services.add(
                    new BroughtUpService(
                        step.name(),
                        step.group(),
                        !stops.isEmpty(),
                        step.kind().name().toLowerCase(Locale.ROOT),
                        step.detail()));
                say(inWords(step));
                stops.forEach(each -> say("But " + each + "."));
              });
      printClassServer(bootstrap);
      OutdatedJarCheck.warnings(phoenix, robot.name(), kept).forEach(each -> say(each + "."));
      namesakes.warning(bootstrap.identities()).ifPresent(answer::note);
    }
  }

  private static String inWords(BringUpStep step) {
    String inGroup = step.name() + " in group " + step.group();
    return switch (step.kind()) {
      case STARTED -> "Up: " + inGroup + ".";
      case UNCHANGED -> "Kept: " + inGroup + "; nothing of it has changed.";
      case RESTARTED ->
          "Restarted: "
              + inGroup
              + (step.detail().isEmpty() ? "." : "; changed: " + step.detail() + ".");
      case MOVED -> "Moved: " + inGroup + "; it was in group " + step.detail() + ".";
      case ENDED -> "Ended: " + inGroup + "; the robot's XML does not have it there any more.";
      case GROUP_STALE ->
          "Kept: process of group "
              + step.name()
              + "; its changed JVM options or class path count from its next start.";
      case GROUP_RESTARTED ->
          "Restarted: process of group " + step.name() + "; " + step.detail() + ".";
      case PROCESS_ENDED ->
          "Ended: process of group "
              + step.name()
              + ", in which phoenix had forgotten "
              + step.detail()
              + (step.detail().equals("1") ? " service" : " services")
              + ", as an interrupted "
              + CommandName.current()
              + " down leaves it.";
      case GROUP_ENDED ->
          "Ended: group " + step.name() + "; the robot's XML does not have it any more.";
    };
  }

  /**
   * The robots, read and validated before any is started.
   *
   * @throws ConfigurationException with all faults of all robots
   */
  private List<RobotDescription> robots() {
    List<RobotDescription> robots = new ArrayList<>();
    List<String> faults = new ArrayList<>();
    for (Path each : xml) {
      try {
        RobotDescription robot = RobotXml.read(each);
        robots.add(robot);
        RobotDryRun.check(robot);
      } catch (ConfigurationException e) {
        faults.add(String.valueOf(e.getMessage()));
      }
    }
    try {
      requireDifferentNames(robots);
    } catch (ConfigurationException e) {
      faults.add(String.valueOf(e.getMessage()));
    }
    if (!faults.isEmpty()) {
      throw new ConfigurationException(String.join("\n", faults));
    }
    return robots;
  }

  /** Two robots of one name on one phoenix would be one, with the last XML. */
  private void requireDifferentNames(List<RobotDescription> robots) {
    Map<String, Path> sources = new HashMap<>();
    for (RobotDescription robot : robots) {
      @Nullable Path other = sources.putIfAbsent(robot.name(), robot.source());
      if (other != null) {
        throw new ConfigurationException(
            robot.source()
                + ": robot "
                + robot.name()
                + " is described in "
                + other
                + " too; give one of the two another name");
      }
    }
  }

  /** A robot without its class server works, but not for clients that lack its classes. */
  private void printClassServer(RobotBootstrap bootstrap) throws IOException, ActivationException {
    Optional<RobotCodebase> classes = bootstrap.codebase();
    if (classes.isPresent()) {
      String place = classes.get().host() + ":" + classes.get().port();
      Optional<String> taken = bootstrap.classServerPortConflict();
      Optional<String> fault =
          taken.isPresent()
              ? Optional.of(
                  taken.get()
                      + ", so clients that lack this robot's classes cannot download them; give one"
                      + " of the two another port in <registrar class-server-port=\"…\">")
              : classes.get().findUnserved();
      say(
          fault.isPresent()
              ? "Classes: " + fault.get() + "."
              : "Classes: served at " + place + ".");
    }
  }

  private void say(String sentence) {
    if (!answer.isJson()) {
      answer.line(sentence, sentence);
    }
  }
}
