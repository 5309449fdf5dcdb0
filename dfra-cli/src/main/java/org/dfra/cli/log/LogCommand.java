package org.dfra.cli.log;

import java.util.Map;
import java.util.concurrent.Callable;
import org.dfra.cli.team.ModuleArgument;
import org.dfra.cli.team.TeamDirectory;
import org.dfra.directory.ModuleListing;
import org.dfra.module.LogLevel;
import org.dfra.module.Module;
import org.dfra.report.terminal.ExitCode;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Parameters;

/** {@code ./dfra log}: the log levels of modules. */
@Command(
    name = "log",
    description = "Shows and sets how much modules write to their logs.",
    synopsisSubcommandLabel = "COMMAND",
    commandListHeading = "%nCommands:%n",
    subcommands = LogCommand.LevelCommand.class)
public final class LogCommand {

  /** {@code ./dfra log level}. */
  @Command(
      name = "level",
      description = "Shows how much a module writes to its log, or sets it.",
      footer = {"", "A level that was set lasts until the module's group is restarted."})
  static final class LevelCommand implements Callable<Integer> {

    @Mixin
    @SuppressWarnings("NullAway.Init") // set by picocli before the call
    private ModuleArgument module;

    @Parameters(
        index = "1",
        arity = "0..1",
        paramLabel = "LEVEL",
        description = "One of ${COMPLETION-CANDIDATES}; each includes those after it.")
    private @Nullable LogLevel level;

    @Override
    public Integer call() throws Exception {
      try (TeamDirectory team = module.open()) {
        ModuleListing<Module> listing = module.find(team);
        if (level != null) {
          listing.module().setLogLevel(level);
        }
        LogLevel now = listing.module().logLevel();
        module
            .answer()
            .sentence(
                Map.of("module", listing.path(), "level", now),
                listing.path() + " logs " + inWords(now) + ".");
        return ExitCode.SUCCESS;
      }
    }

    private static String inWords(LogLevel level) {
      return switch (level) {
        case TRACE -> "everything (TRACE)";
        case ERROR -> "errors only (ERROR)";
        default -> level + " and above";
      };
    }
  }
}
