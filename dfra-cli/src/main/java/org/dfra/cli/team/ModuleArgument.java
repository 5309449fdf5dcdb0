package org.dfra.cli.team;

import java.io.IOException;
import org.dfra.directory.ModuleListing;
import org.dfra.module.Module;
import org.dfra.report.terminal.CommandOutput;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Parameters;

/** The module argument of a command, and where the module is discovered. A picocli mix-in. */
public final class ModuleArgument {

  @Parameters(
      index = "0",
      paramLabel = "ROBOT/MODULE",
      description =
          "The module; the robot may be omitted if only one has such a module. If several robots"
              + " have the same name: ROBOT@HOST/MODULE.")
  private String name = "";

  @Mixin
  @SuppressWarnings("NullAway.Init") // set by picocli before the call
  private TeamOptions options;

  /** The argument's text. */
  public String name() {
    return name;
  }

  /** The command's output. */
  public CommandOutput answer() {
    return options.answer();
  }

  /** Starts the discovery. */
  public TeamDirectory open() throws IOException {
    return options.open();
  }

  /** The module. */
  public ModuleListing<Module> find(TeamDirectory team) throws InterruptedException {
    return team.module(name);
  }
}
