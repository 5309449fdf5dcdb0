package org.dfra.app.recruit;

import picocli.CommandLine.Command;

/** {@code ./dfra recruit}: how robots ask each other for help. */
@Command(
    name = "recruit",
    description = "Shows which robots help, has held ones help again, and compares strategies.",
    synopsisSubcommandLabel = "VERB",
    commandListHeading = "%nVerbs:%n",
    subcommands = {RecruitStatusCommand.class, RecruitResumeCommand.class, ExperimentCommand.class})
public final class RecruitCommand {}
