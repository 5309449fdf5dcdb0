package org.dfra.app.log;

import picocli.CommandLine.Command;

/** {@code ./dfra log}: the log levels of modules. */
@Command(
    name = "log",
    description = "Tells and sets how much modules write to their logs.",
    synopsisSubcommandLabel = "VERB",
    commandListHeading = "%nVerbs:%n",
    subcommands = LevelCommand.class)
public final class LogCommand {}
