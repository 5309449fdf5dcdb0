package org.dfra.app.recruit;

import picocli.CommandLine.Command;

/** {@code ./dfra recruit}: how robots ask each other for help. */
@Command(
    name = "recruit",
    description = "Judges how robots ask each other for help.",
    synopsisSubcommandLabel = "VERB",
    commandListHeading = "%nVerbs:%n",
    subcommands = {ExperimentCommand.class})
public final class RecruitCommand {}
