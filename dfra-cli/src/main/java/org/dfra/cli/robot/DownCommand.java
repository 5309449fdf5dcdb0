package org.dfra.cli.robot;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.rmi.activation.ActivationException;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.Callable;
import org.dfra.cli.team.PhoenixOptions;
import org.dfra.core.config.NearestName;
import org.dfra.core.config.RobotXml;
import org.dfra.report.terminal.CommandFailure;
import org.dfra.report.terminal.CommandOutput;
import org.dfra.report.terminal.ExitCode;
import org.dfra.river.bootstrap.PhoenixProcess;
import org.dfra.river.bootstrap.RobotRemoval;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Parameters;

/** {@code ./dfra down}. */
@Command(
    name = "down",
    description = "Takes down robots of this host, or all of them and phoenix.",
    footer = {
      "",
      "Without ROBOT, every robot of this host and phoenix itself end; otherwise phoenix",
      "continues. Phoenix forgets a robot that is taken down, and does not restart it. When",
      "the robot is brought up again, its modules have the same identities as before, and an",
      "emergency stop stays in force until it is released."
    })
public final class DownCommand implements Callable<Integer> {

  @Parameters(
      paramLabel = "ROBOT",
      arity = "0..*",
      description = "Robots by name or XML (default: everything on this host).")
  private List<String> robots = List.of();

  @Mixin
  @SuppressWarnings("NullAway.Init") // set by picocli before the call
  private PhoenixOptions options;

  @Mixin
  @SuppressWarnings("NullAway.Init") // set by picocli before the call
  private CommandOutput answer;

  @Override
  public Integer call() throws Exception {
    PhoenixProcess phoenix = options.lastStarted();
    phoenix.requireOwnedByUser();
    if (!phoenix.isResponding(PhoenixOptions.TIMEOUT)) {
      answer.sentence(
          Map.of("phoenix", "none"),
          "No phoenix answers on port " + phoenix.port() + "; nothing is up.");
      return ExitCode.SUCCESS;
    }
    if (robots.isEmpty()) {
      RobotRemoval.removeAllRobots(phoenix, PhoenixOptions.TIMEOUT);
      phoenix.shutdown(PhoenixOptions.TIMEOUT);
      answer.sentence(Map.of("phoenix", "ended"), "Phoenix and its groups have ended.");
      return ExitCode.SUCCESS;
    }
    List<String> names = names(phoenix);
    for (String name : names) {
      RobotRemoval.removeRobot(phoenix, name, PhoenixOptions.TIMEOUT);
      answer.line(Map.of("robot", name, "down", true), name + " is down.");
    }
    return ExitCode.SUCCESS;
  }

  /** The robots' names; all are checked before any robot is shut down. */
  private List<String> names(PhoenixProcess phoenix) throws IOException, ActivationException {
    List<String> known = RobotRemoval.robots(phoenix, PhoenixOptions.TIMEOUT);
    List<String> names = new ArrayList<>();
    for (String each : robots) {
      String name =
          each.endsWith(".xml") || Files.exists(Path.of(each))
              ? RobotXml.read(Path.of(each)).name()
              : each;
      if (!known.contains(name)) {
        throw new CommandFailure(
            ExitCode.NOT_FOUND,
            "robot "
                + name
                + " is not up on this host"
                + NearestName.hint(
                    name,
                    known,
                    known.isEmpty() ? "; none is" : "; there is " + String.join(", ", known)));
      }
      names.add(name);
    }
    return names;
  }
}
