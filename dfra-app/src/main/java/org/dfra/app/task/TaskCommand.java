package org.dfra.app.task;

import picocli.CommandLine.Command;

/** {@code ./dfra task}: what robots are told to do. */
@Command(
    name = "task",
    description = "Tells robots what to do, and how far they are.",
    synopsisSubcommandLabel = "VERB",
    commandListHeading = "%nVerbs:%n",
    subcommands = {
      SubmitCommand.class,
      StatusCommand.class,
      PauseCommand.class,
      ResumeCommand.class,
      CancelCommand.class
    })
public final class TaskCommand {}
