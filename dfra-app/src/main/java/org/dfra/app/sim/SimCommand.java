package org.dfra.app.sim;

import picocli.CommandLine.Command;

/** {@code ./dfra sim}: simulated worlds. */
@Command(
    name = "sim",
    description = "Simulates robots, their devices byte by byte, and the field they are in.",
    synopsisSubcommandLabel = "VERB",
    commandListHeading = "%nVerbs:%n",
    subcommands = {RunCommand.class})
public final class SimCommand {}
