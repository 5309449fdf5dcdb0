package org.dfra.cli.module;

import java.util.Map;
import org.dfra.cli.team.PhoenixOptions;
import org.dfra.core.config.RobotDescription;
import org.dfra.core.host.CommandName;
import org.dfra.report.terminal.CommandFailure;
import org.dfra.report.terminal.CommandOutput;
import org.dfra.report.terminal.ExitCode;
import org.dfra.river.bootstrap.PhoenixInventory.ServiceGroup;
import org.dfra.river.bootstrap.PhoenixProcess;
import org.dfra.river.bootstrap.RobotBootstrap;
import org.dfra.river.bootstrap.RobotDescriptionStore;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Parameters;

/** A module that is registered with the phoenix of this host. A picocli mix-in. */
final class LocalModule {

  @Parameters(index = "0", paramLabel = "ROBOT/MODULE", description = "A module of this host.")
  private String module = "";

  @Mixin
  @SuppressWarnings("NullAway.Init") // set by picocli before the call
  private PhoenixOptions options;

  @Mixin
  @SuppressWarnings("NullAway.Init") // set by picocli before the call
  private CommandOutput answer;

  /** An action on the module. */
  interface ModuleAction {
    void apply(RobotBootstrap robot, String module) throws Exception;
  }

  /**
   * Executes the action and reports it.
   *
   * @param done its result, such as {@code removed}
   */
  void change(ModuleAction action, String done) throws Exception {
    PhoenixProcess phoenix = options.requireRunning();
    ServiceGroup group = ServiceGroupFinder.of(phoenix, module);
    RobotDescription robot =
        new RobotDescriptionStore(options.state())
            .find(group.robot())
            .orElseThrow(
                () ->
                    new CommandFailure(
                        ExitCode.FAILED,
                        "what is known of "
                            + group.robot()
                            + " is gone; bring it up once more: "
                            + CommandName.current()
                            + " up ROBOT.XML"));
    action.apply(new RobotBootstrap(phoenix, robot), module.substring(module.indexOf('/') + 1));
    answer.sentence(
        Map.of("module", module, "group", group.name(), done, true),
        module + " in group " + group.name() + " is " + done + ".");
  }
}
