package org.dfra.cli.robot;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.concurrent.Callable;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.dfra.cli.team.PhoenixOptions;
import org.dfra.core.config.RobotXml;
import org.dfra.core.host.CommandName;
import org.dfra.report.terminal.CommandOutput;
import org.dfra.report.terminal.ExitCode;
import org.dfra.report.terminal.Table;
import org.dfra.river.bootstrap.BudgetSurvey;
import org.dfra.river.bootstrap.PhoenixInventory;
import org.dfra.river.bootstrap.PhoenixInventory.ServiceGroup;
import org.dfra.river.bootstrap.PhoenixProcess;
import org.dfra.river.bootstrap.StoredStopStates;
import org.dfra.river.phoenix.GroupStatus;
import org.dfra.river.security.SecureProcess;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** {@code ./dfra status}. */
@Command(
    name = "status",
    description = "Shows the state of the service groups of this host's robots.",
    footer = {
      "",
      "Exits with 4 if phoenix does not answer. For the modules: "
          + CommandName.IN_HELP
          + " module list."
    })
public final class StatusCommand implements Callable<Integer> {

  @Parameters(
      paramLabel = "ROBOT",
      arity = "0..*",
      description = "Only these robots, by name or XML (default: all of this host).")
  private List<String> robots = List.of();

  @Option(
      names = "--budget",
      description =
          "Show what callers and modules have used of the budgets of the team's policy, over the"
              + " last 10 s, and what was refused, slowed or not sent since the policy is in"
              + " force.")
  private boolean isBudget;

  @Mixin
  @SuppressWarnings("NullAway.Init") // set by picocli before the call
  private PhoenixOptions options;

  @Mixin
  @SuppressWarnings("NullAway.Init") // set by picocli before the call
  private CommandOutput answer;

  /**
   * A group in the command's output.
   *
   * @param services its running services
   * @param idle its services that do not run: they did not start, crashed or were stopped
   * @param stopped its effectors in emergency stop
   */
  record Group(
      String robot,
      String group,
      String state,
      long pid,
      long started,
      int crashes,
      @Nullable String lastCrash,
      List<String> services,
      List<String> idle,
      List<String> stopped,
      String log) {}

  @Override
  public Integer call() throws Exception {
    List<String> wanted = new ArrayList<>();
    for (String each : robots) {
      boolean isFile = each.endsWith(".xml") || Files.exists(Path.of(each));
      wanted.add(isFile ? RobotXml.read(Path.of(each)).name() : each);
    }
    PhoenixProcess phoenix = options.requireRunning();
    if (isBudget) {
      BudgetTable.show(answer, BudgetSurvey.of(phoenix, Set.copyOf(wanted)));
      return ExitCode.SUCCESS;
    }
    List<Group> groups = new ArrayList<>();
    for (ServiceGroup each : PhoenixInventory.groups(phoenix, PhoenixOptions.TIMEOUT)) {
      if (wanted.isEmpty() || wanted.contains(each.robot())) {
        groups.add(group(each, phoenix.state()));
      }
    }
    Table table = new Table("GROUP", "STATE", "PROCESS", "STARTS", "CRASHES", "SERVICES");
    for (Group each : groups) {
      table.row(
          each.robot() + "." + each.group(),
          each.state(),
          each.pid() < 0 ? "-" : Long.toString(each.pid()),
          Long.toString(each.started()),
          Integer.toString(each.crashes()),
          services(each));
    }
    answer.table(groups, table, "Phoenix answers, but no such robot is up on this host.");
    if (!answer.isJson()) {
      answer.line(security(), security() + ".");
      SecureProcess.clockFault().ifPresent(fault -> answer.line(fault, "Clock: " + fault + "."));
      for (Group each : groups) {
        StoppedEffectors.notices(phoenix.state(), each.robot(), each.stopped())
            .forEach(sentence -> answer.line(sentence, sentence + "."));
      }
    }
    return ExitCode.SUCCESS;
  }

  /** Who may call the robots of this computer, as a sentence without a full stop. */
  private static String security() {
    SecureProcess.Installed own = SecureProcess.current();
    return switch (own.mode()) {
      case OPEN -> "Open: every program that reaches these robots may call them";
      case SECURE -> "Secure: members of the team only; this computer is " + own.name();
      case CLOSED -> "Closed: " + own.name() + " works for itself only, since " + own.fault();
    };
  }

  private static String services(Group group) {
    return Stream.concat(
            group.services().stream(), group.idle().stream().map(each -> each + " (not running)"))
        .collect(Collectors.joining(", "));
  }

  private static Group group(ServiceGroup group, Path kept) {
    GroupStatus status = group.status();
    List<String> services = new ArrayList<>();
    List<String> idle = new ArrayList<>();
    switch (group.registrar()) {
      case NONE -> {}
      case NOT_RUNNING -> idle.add("registrar");
      case RUNNING -> services.add("registrar");
    }
    for (String module : group.modules()) {
      (group.runningModules().contains(module) ? services : idle).add(module);
    }
    String state = status.state().name().toLowerCase(Locale.ROOT);
    return new Group(
        group.robot(),
        group.name(),
        status.heldOffUntil() == null ? state : "held off until " + status.heldOffUntil(),
        status.pid(),
        status.incarnation(),
        status.totalCrashes(),
        status.lastCrash(),
        services,
        idle,
        List.copyOf(StoredStopStates.latched(kept, group.robot(), group.modules()).keySet()),
        status.output());
  }

  /** The emergency stops of this host's effectors, as text. */
  static final class StoppedEffectors {

    private StoppedEffectors() {}

    /**
     * A sentence with the remedy for each of a robot's modules in emergency stop.
     *
     * @param state phoenix's state folder
     */
    static List<String> notices(Path state, String robot, Collection<String> modules) {
      return StoredStopStates.latched(state, robot, modules).entrySet().stream()
          .map(
              each ->
                  robot
                      + "/"
                      + each.getKey()
                      + " is stopped for an emergency "
                      + each.getValue().inWords()
                      + "; when it is safe: "
                      + CommandName.current()
                      + " stop --release "
                      + robot)
          .toList();
    }
  }
}
