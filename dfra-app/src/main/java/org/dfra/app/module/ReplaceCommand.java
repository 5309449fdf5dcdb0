package org.dfra.app.module;

import java.util.Map;
import java.util.concurrent.Callable;
import org.dfra.app.terminal.ExitCode;
import org.dfra.river.bootstrap.RobotBootstrap;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;

/** {@code ./dfra module replace}. */
@Command(
    name = "replace",
    description = "Replaces a module of a running robot of this host by what its XML says now.",
    footer = {
      "",
      "The module keeps its identity: whoever has its proxy goes on with the new one.",
      "The others work on."
    })
final class ReplaceCommand implements Callable<Integer> {

  @Mixin
  @SuppressWarnings("NullAway.Init") // set by picocli before the call
  private ConfiguredModuleArgument described;

  @Override
  public Integer call() throws Exception {
    RobotBootstrap.ServiceReference service =
        described.change((robot, module, group) -> robot.replace(module));
    described
        .answer()
        .sentence(
            Map.of("module", service.name(), "group", service.group(), "replaced", true),
            "Replaced " + service.name() + " in group " + service.group() + ".");
    return ExitCode.SUCCESS;
  }
}
