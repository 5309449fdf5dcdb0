package org.dfra.app.module;

import java.util.Map;
import java.util.concurrent.Callable;
import org.dfra.app.team.PhoenixOptions;
import org.dfra.app.terminal.Answer;
import org.dfra.app.terminal.CommandFailure;
import org.dfra.app.terminal.ExitCode;
import org.dfra.core.config.RobotDescription;
import org.dfra.river.bootstrap.Inventory.ServiceGroup;
import org.dfra.river.bootstrap.KnownRobots;
import org.dfra.river.bootstrap.PhoenixProcess;
import org.dfra.river.bootstrap.RobotBootstrap;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Parameters;

/** {@code ./dfra module remove}. */
@Command(
    name = "remove",
    description = "Removes a module from a running robot of this host, while the others work.",
    footer = {"", "It comes back when the robot is brought up with an XML in which it still is."})
final class RemoveCommand implements Callable<Integer> {

  @Parameters(index = "0", paramLabel = "ROBOT/MODULE", description = "The module.")
  private String module = "";

  @Mixin
  @SuppressWarnings("NullAway.Init") // picocli sets it before it calls
  private PhoenixOptions options;

  @Mixin
  @SuppressWarnings("NullAway.Init") // picocli sets it before it calls
  private Answer answer;

  @Override
  public Integer call() throws Exception {
    PhoenixProcess phoenix = options.running();
    ServiceGroup group = LocalGroup.of(phoenix, module);
    RobotDescription robot =
        new KnownRobots(options.state())
            .find(group.robot())
            .orElseThrow(
                () ->
                    new CommandFailure(
                        ExitCode.FAILED,
                        "what is known of "
                            + group.robot()
                            + " is gone; bring it up once more: ./dfra up ROBOT.XML"));
    new RobotBootstrap(phoenix, robot).remove(module.substring(module.indexOf('/') + 1));
    answer.sentence(
        Map.of("module", module, "group", group.name(), "removed", true),
        "Removed " + module + " from group " + group.name() + ".");
    return ExitCode.WELL;
  }
}
