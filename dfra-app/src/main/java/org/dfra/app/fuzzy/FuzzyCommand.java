package org.dfra.app.fuzzy;

import picocli.CommandLine.Command;

/** {@code ./dfra fuzzy}: fuzzy systems in {@code .fis} files. */
@Command(
    name = "fuzzy",
    description = "Shows fuzzy systems.",
    synopsisSubcommandLabel = "VERB",
    commandListHeading = "%nVerbs:%n",
    subcommands = FuzzyShowCommand.class)
public final class FuzzyCommand {}
