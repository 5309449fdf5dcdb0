package org.dfra.app.team;

import org.dfra.directory.ModuleListing;
import org.dfra.module.Module;
import picocli.CommandLine.Parameters;

/** The module that a command is about. A picocli mix-in. */
public final class ModuleArgument {

  @Parameters(
      index = "0",
      paramLabel = "ROBOT/MODULE",
      description = "The module; the robot may be left out where only one has such a module.")
  private String name = "";

  /** As it was written. */
  public String name() {
    return name;
  }

  /** The module. */
  public ModuleListing<Module> in(Team team) throws InterruptedException {
    return team.module(name);
  }
}
