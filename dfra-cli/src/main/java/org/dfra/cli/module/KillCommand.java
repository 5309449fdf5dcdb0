package org.dfra.cli.module;

import java.util.Map;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.concurrent.TimeUnit;
import org.dfra.cli.team.PhoenixOptions;
import org.dfra.report.terminal.CommandFailure;
import org.dfra.report.terminal.CommandOutput;
import org.dfra.report.terminal.ExitCode;
import org.dfra.river.bootstrap.PhoenixInventory.ServiceGroup;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Parameters;

/** {@code ./dfra module kill}. */
@Command(
    name = "kill",
    description = "Crashes the virtual machine of a module's group, on this host.",
    footer = {"", "All modules of the group crash with it. Phoenix restarts them."})
final class KillCommand implements Callable<Integer> {

  @Parameters(index = "0", paramLabel = "ROBOT/MODULE", description = "The module.")
  private String module = "";

  @Mixin
  @SuppressWarnings("NullAway.Init") // set by picocli before the call
  private PhoenixOptions phoenix;

  @Mixin
  @SuppressWarnings("NullAway.Init") // set by picocli before the call
  private CommandOutput answer;

  @Override
  public Integer call() throws Exception {
    ServiceGroup group = ServiceGroupFinder.of(phoenix.requireRunning(), module);
    long pid = group.status().pid();
    Optional<ProcessHandle> process = pid < 0 ? Optional.empty() : ProcessHandle.of(pid);
    if (process.isEmpty()) {
      throw new CommandFailure(
          ExitCode.FAILED,
          "group " + group.name() + " of " + group.robot() + " has no process; nothing to kill");
    }
    process.get().destroyForcibly();
    process.get().onExit().get(PhoenixOptions.TIMEOUT.toSeconds(), TimeUnit.SECONDS);
    answer.sentence(
        Map.of("robot", group.robot(), "group", group.name(), "pid", pid),
        "Killed group "
            + group.name()
            + " of "
            + group.robot()
            + ": process "
            + pid
            + " with "
            + String.join(", ", group.modules())
            + ".");
    return ExitCode.SUCCESS;
  }
}
