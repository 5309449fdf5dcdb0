package org.dfra.app.module;

import java.util.Map;
import java.util.concurrent.Callable;
import org.dfra.app.terminal.ExitCode;
import org.dfra.river.bootstrap.RobotBootstrap;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;

/** {@code ./dfra module add}. */
@Command(
    name = "add",
    description = "Adds a module to a running robot of this host, while the others work.",
    footer = {"", "Write it into the robot's XML first; then name the XML and the module."})
final class AddCommand implements Callable<Integer> {

  @Mixin
  @SuppressWarnings("NullAway.Init") // set by picocli before the call
  private ConfiguredModuleArgument described;

  @Override
  public Integer call() throws Exception {
    RobotBootstrap.ServiceReference service = described.change(RobotBootstrap::add);
    described
        .answer()
        .sentence(
            Map.of("module", service.name(), "group", service.group(), "added", true),
            "Added " + service.name() + " to group " + service.group() + ".");
    return ExitCode.SUCCESS;
  }
}
