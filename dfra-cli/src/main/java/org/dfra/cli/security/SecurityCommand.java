package org.dfra.cli.security;

import picocli.CommandLine.Command;

/** {@code ./dfra security}: the members of a team; {@code dfra-authority} adds its verbs. */
@Command(
    name = "security",
    description = "Joins a team whose members know each other, and manages its members.",
    synopsisSubcommandLabel = "COMMAND",
    commandListHeading = "%nCommands:%n",
    subcommands = {
      JoinCommand.class,
      ShowCommand.class,
      DelegateCommand.class,
      AcceptCommand.class
    })
public final class SecurityCommand {}
