package org.dfra.app.module;

import java.util.concurrent.Callable;
import org.dfra.app.terminal.ExitCode;
import org.dfra.river.bootstrap.RobotBootstrap;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;

/** {@code ./dfra module remove}. */
@Command(
    name = "remove",
    description = "Removes a module from a running robot of this host, while the others work.",
    footer = {"", "It comes back when the robot is brought up with an XML in which it still is."})
final class RemoveCommand implements Callable<Integer> {

  @Mixin
  @SuppressWarnings("NullAway.Init") // set by picocli before the call
  private LocalModule local;

  @Override
  public Integer call() throws Exception {
    local.change(RobotBootstrap::remove, "removed");
    return ExitCode.SUCCESS;
  }
}
