package org.dfra.cli.policy;

import picocli.CommandLine.Command;

/** {@code ./dfra policy}: who may do what with the robots of a team. */
@Command(
    name = "policy",
    description = "Checks and explains who may do what with the robots of a team.",
    synopsisSubcommandLabel = "COMMAND",
    commandListHeading = "%nCommands:%n",
    subcommands = {CheckCommand.class, ExplainCommand.class})
public final class PolicyCommand {}
