package org.dfra.report.fuzzy;

import picocli.CommandLine.Command;

/** {@code ./dfra fuzzy}: fuzzy systems in {@code .fis} files. */
@Command(
    name = "fuzzy",
    description = "Shows fuzzy systems.",
    synopsisSubcommandLabel = "COMMAND",
    commandListHeading = "%nCommands:%n",
    subcommands = FuzzyShowCommand.class)
final class FuzzyCommand {}
