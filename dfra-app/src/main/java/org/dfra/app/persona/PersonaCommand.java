package org.dfra.app.persona;

import picocli.CommandLine.Command;

/** {@code ./dfra persona}: the attributes that the team's robots publish. */
@Command(
    name = "persona",
    description = "Shows the team's robots, and finds modules by what they can do.",
    synopsisSubcommandLabel = "VERB",
    commandListHeading = "%nVerbs:%n",
    subcommands = {PersonaListCommand.class, PersonaShowCommand.class, FindCommand.class})
public final class PersonaCommand {}
