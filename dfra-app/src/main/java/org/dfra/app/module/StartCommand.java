package org.dfra.app.module;

import java.util.concurrent.Callable;
import org.dfra.app.terminal.ExitCode;
import org.dfra.river.bootstrap.RobotBootstrap;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;

/** {@code ./dfra module start}. */
@Command(
    name = "start",
    description = "Starts a module of this host that was stopped or has crashed.",
    footer = {"", "Where it runs already, nothing happens."})
final class StartCommand implements Callable<Integer> {

  @Mixin
  @SuppressWarnings("NullAway.Init") // set by picocli before the call
  private LocalModule local;

  @Override
  public Integer call() throws Exception {
    local.change(RobotBootstrap::start, "started");
    return ExitCode.SUCCESS;
  }
}
