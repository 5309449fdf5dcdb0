package org.dfra.cli.doctor;

import java.io.IOException;
import java.nio.file.Path;
import java.rmi.RemoteException;
import java.time.Duration;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.OptionalLong;
import java.util.concurrent.Callable;
import org.dfra.cli.doctor.CheckRunner.Check;
import org.dfra.cli.doctor.Finding.Verdict;
import org.dfra.cli.team.TeamOptions;
import org.dfra.core.config.ConfigurationException;
import org.dfra.core.config.RegistrarDescription;
import org.dfra.core.config.RobotDescription;
import org.dfra.report.terminal.CommandOutput;
import org.dfra.report.terminal.ExitCode;
import org.dfra.report.terminal.Terminal;
import org.dfra.river.bootstrap.PhoenixProcess;
import org.dfra.river.phoenix.GroupStatus;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Help.Ansi;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Spec;

/** {@code ./dfra doctor}. */
@Command(
    name = "doctor",
    description = "Reports what is wrong with this computer and the team it sees, and what to do.",
    footer = {
      "",
      "It changes nothing. Exits with 1 if a check fails; a warning is not a failure.",
      "docs/troubleshooting.md has a section for each finding."
    })
public final class DoctorCommand implements Callable<Integer> {

  /** A phoenix that does not answer on its own host within this time is suspended or hangs. */
  private static final Duration DEADLINE = Duration.ofSeconds(2);

  @Mixin
  @SuppressWarnings("NullAway.Init") // set by picocli before the call
  private TeamOptions team;

  @Spec
  @SuppressWarnings("NullAway.Init") // set by picocli before the call
  private CommandSpec spec;

  /** A finding in JSON output. */
  record FindingView(String subject, String verdict, String what, @Nullable String remedy) {}

  /**
   * All findings.
   *
   * @param ok whether none of them is a failure
   */
  record Report(boolean ok, List<FindingView> findings) {}

  @Override
  public Integer call() throws Exception {
    List<Finding> findings = examine();
    boolean well = findings.stream().noneMatch(each -> each.verdict() == Verdict.FAIL);
    CommandOutput answer = team.answer();
    if (answer.isJson()) {
      answer.details(new Report(well, findings.stream().map(DoctorCommand::view).toList()));
    } else {
      Ansi ansi = spec.commandLine().getColorScheme().ansi();
      answer.preformatted(new FindingPrinter(ansi, Terminal.textColumns()).of(findings));
    }
    return well ? ExitCode.SUCCESS : ExitCode.FAILED;
  }

  private List<Finding> examine() throws IOException, InterruptedException {
    PhoenixProcess phoenix = team.phoenix();
    List<Check> checks = new ArrayList<>();
    checks.add(JavaCheck.ofThisProcess());
    checks.add(BootJarCheck.ofThisProcess());
    checks.add(ArchiveCheck.ofThisProcess());
    checks.add(IdentityCheck.ofThisProcess());
    checks.add(FileDescriptorCheck.ofThisProcess());
    checks.add(HostCheck.ofThisComputer(team.hostSetting()));
    checks.add(new MulticastCheck(new JiniMulticast(), team.groups()));
    checks.add(new PortCheck(new ListeningPorts(Path.of("/proc")), ports(phoenix)));
    checks.add(StateCheck.of(team.state()));
    checks.add(new PhoenixCheck(asked(phoenix)));
    try (TeamSurvey survey = TeamSurvey.open(team)) {
      boolean isRobotUp = phoenix.pid().isPresent();
      checks.add(new RegistrarCheck(survey, team.namedLocators(), isRobotUp));
      checks.add(new NameCheck(survey));
      checks.add(new ClockCheck(survey));
      checks.add(new ModuleCheck(survey));
      checks.add(new StopCheck(survey));
      checks.add(ExposureCheck.of(team.knownRobots()));
      return CheckRunner.run(checks);
    } catch (ConfigurationException | IOException e) {
      List<Finding> findings = new ArrayList<>(CheckRunner.run(checks));
      Finding unable =
          Finding.fail(
              Subject.REGISTRAR,
              e,
              "Correct that first; until then no lookup service can be found.");
      if (findings.stream().noneMatch(each -> each.what().equals(unable.what()))) {
        findings.add(unable);
      }
      return findings;
    }
  }

  /** The ports that phoenix and the robots of this host need, or else the default ports. */
  private Map<Integer, String> ports(PhoenixProcess phoenix) throws IOException {
    Map<Integer, String> uses = new LinkedHashMap<>();
    uses.put(phoenix.port(), "phoenix");
    if (phoenix.registryPort() >= 0) {
      uses.put(phoenix.registryPort(), "phoenix's RMI registry");
    }
    int ofPhoenix = uses.size();
    for (RobotDescription robot : team.knownRobots()) {
      robot
          .registrar()
          .ifPresent(
              registrar -> {
                uses.put(registrar.port(), robot.name() + "'s registrar");
                uses.put(registrar.classServerPort(), robot.name() + "'s class server");
              });
    }
    uses.remove(0); // chosen by the system, or none
    if (uses.size() == ofPhoenix) {
      uses.put(RegistrarDescription.DEFAULT_PORT, "a registrar");
      uses.put(RegistrarDescription.DEFAULT_CLASS_SERVER_PORT, "a class server");
    }
    return uses;
  }

  private PhoenixCheck.Daemon asked(PhoenixProcess phoenix) {
    Duration patience = team.timeout();
    return new PhoenixCheck.Daemon() {
      @Override
      public String address() {
        return phoenix.host() + ":" + phoenix.port();
      }

      @Override
      public OptionalLong pid() {
        return phoenix.pid();
      }

      @Override
      public List<GroupStatus> groups() throws RemoteException {
        return phoenix.groupStatus(DEADLINE, patience);
      }

      @Override
      public String log() {
        return phoenix.log().toString();
      }
    };
  }

  private static FindingView view(Finding finding) {
    return new FindingView(
        finding.subject().id(),
        finding.verdict().name().toLowerCase(Locale.ROOT),
        finding.what(),
        finding.remedy());
  }
}
