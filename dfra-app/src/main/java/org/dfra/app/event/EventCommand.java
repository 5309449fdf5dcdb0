package org.dfra.app.event;

import picocli.CommandLine.Command;

/** {@code ./dfra event}: the events that modules publish. */
@Command(
    name = "event",
    description = "Listens to a module: what it tells, how often and how much.",
    synopsisSubcommandLabel = "VERB",
    commandListHeading = "%nVerbs:%n",
    subcommands = {EchoCommand.class, HzCommand.class, BwCommand.class, NoiseCommand.class})
public final class EventCommand {}
