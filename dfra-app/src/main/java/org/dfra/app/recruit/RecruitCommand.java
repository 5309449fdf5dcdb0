package org.dfra.app.recruit;

import picocli.CommandLine.Command;

/** {@code ./dfra recruit}: recruitment of helpers among robots. */
@Command(
    name = "recruit",
    description = "Shows which robots help, has held ones help again, and compares strategies.",
    synopsisSubcommandLabel = "VERB",
    commandListHeading = "%nVerbs:%n",
    subcommands = {RecruitStatusCommand.class, RecruitResumeCommand.class, ExperimentCommand.class})
public final class RecruitCommand {}
