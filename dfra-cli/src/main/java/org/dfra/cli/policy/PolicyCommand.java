package org.dfra.cli.policy;

import picocli.CommandLine.Command;

/** {@code ./dfra policy}: who may do what with the robots of a team. */
@Command(
    name = "policy",
    description = {
      "Checks and explains who may do what with the robots of a team, sets the facts on which it",
      "depends, and confirms calls."
    },
    synopsisSubcommandLabel = "COMMAND",
    commandListHeading = "%nCommands:%n",
    subcommands = {
      CheckCommand.class,
      ExplainCommand.class,
      FactCommand.class,
      RequestsCommand.class,
      AnswerCommands.Confirm.class,
      AnswerCommands.Refuse.class
    })
public final class PolicyCommand {}
