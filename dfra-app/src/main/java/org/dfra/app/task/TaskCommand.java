package org.dfra.app.task;

import picocli.CommandLine.Command;

/** {@code ./dfra task}: the goals of robots. */
@Command(
    name = "task",
    description = "Tells robots what to do, and how far they are.",
    synopsisSubcommandLabel = "VERB",
    commandListHeading = "%nVerbs:%n",
    subcommands = {
      SubmitCommand.class,
      TaskStatusCommand.class,
      PauseCommand.class,
      TaskResumeCommand.class,
      CancelCommand.class
    })
public final class TaskCommand {}
