package org.dfra.app.module;

import picocli.CommandLine.Command;

/** {@code ./dfra module}: queries and changes of modules. */
@Command(
    name = "module",
    description = "Lists the team's modules, asks and changes them.",
    synopsisSubcommandLabel = "VERB",
    commandListHeading = "%nVerbs:%n",
    subcommands = {
      ModuleListCommand.class,
      InfoCommand.class,
      CallCommand.class,
      GetCommand.class,
      SetCommand.class,
      StartCommand.class,
      ModuleStopCommand.class,
      KillCommand.class,
      AddCommand.class,
      ReplaceCommand.class,
      RemoveCommand.class,
      DiagnoseCommand.class,
      RecoverCommand.class
    })
public final class ModuleCommand {}
