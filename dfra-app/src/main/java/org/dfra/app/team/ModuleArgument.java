package org.dfra.app.team;

import java.io.IOException;
import org.dfra.app.terminal.CommandOutput;
import org.dfra.directory.ModuleListing;
import org.dfra.module.Module;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Parameters;

/** The module that a command is about, and where it is looked for. A picocli mix-in. */
public final class ModuleArgument {

  @Parameters(
      index = "0",
      paramLabel = "ROBOT/MODULE",
      description =
          "The module; the robot may be left out where only one has such a module. Where several"
              + " robots have one name: ROBOT@HOST/MODULE.")
  private String name = "";

  @Mixin
  @SuppressWarnings("NullAway.Init") // picocli sets it before it calls
  private TeamOptions options;

  /** As it was written. */
  public String name() {
    return name;
  }

  /** How the command answers. */
  public CommandOutput answer() {
    return options.answer();
  }

  /** Begins to look for it. */
  public TeamDirectory open() throws IOException {
    return options.open();
  }

  /** The module. */
  public ModuleListing<Module> find(TeamDirectory team) throws InterruptedException {
    return team.module(name);
  }
}
