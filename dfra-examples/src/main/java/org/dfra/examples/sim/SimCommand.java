package org.dfra.examples.sim;

import picocli.CommandLine.Command;

/** {@code ./dfra sim}: simulated worlds. */
@Command(
    name = "sim",
    description = "Simulates robots, the byte protocols of their devices, and their field.",
    synopsisSubcommandLabel = "COMMAND",
    commandListHeading = "%nCommands:%n",
    subcommands = {RunCommand.class})
final class SimCommand {}
