package org.dfra.app.lease;

import picocli.CommandLine.Command;

/** {@code ./dfra lease}: leases on modules and their holders. */
@Command(
    name = "lease",
    description = "Tells who holds leases on the team's modules, and revokes them.",
    synopsisSubcommandLabel = "VERB",
    commandListHeading = "%nVerbs:%n",
    subcommands = {LeaseListCommand.class, RevokeCommand.class})
public final class LeaseCommand {}
