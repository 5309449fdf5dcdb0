package org.dfra.app.lease;

import java.util.List;
import java.util.Map;
import java.util.concurrent.Callable;
import java.util.stream.Collectors;
import org.dfra.app.team.Administration;
import org.dfra.app.team.ModuleArgument;
import org.dfra.app.team.TeamDirectory;
import org.dfra.app.terminal.CommandFailure;
import org.dfra.app.terminal.ExitCode;
import org.dfra.directory.ModuleListing;
import org.dfra.lease.LeaseHandle;
import org.dfra.lease.LeaseStatus;
import org.dfra.module.Module;
import org.dfra.river.remote.ModuleAdmin;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Parameters;

/** {@code ./dfra lease revoke}. */
@Command(
    name = "revoke",
    description = "Ends a lease before its time, against its holder's will.",
    footer = {
      "",
      "Its holder hears of it at its next renewal, within a second, and does not come",
      "back by itself. It may ask for a new lease."
    })
final class RevokeCommand implements Callable<Integer> {

  @Mixin
  @SuppressWarnings("NullAway.Init") // set by picocli before the call
  private ModuleArgument module;

  @Parameters(
      index = "1",
      paramLabel = "LEASE",
      description = "The lease, or how its name begins; ./dfra lease list tells it.")
  private String lease = "";

  @Override
  public Integer call() throws Exception {
    try (TeamDirectory team = module.open()) {
      ModuleListing<Module> listing = module.find(team);
      ModuleAdmin admin = Administration.of(listing);
      LeaseView found = find(listing.path(), admin.leases());
      if (!admin.revoke(new LeaseHandle(found.id()))) {
        throw new CommandFailure(
            ExitCode.NOT_FOUND, "lease " + found.shortId() + " has just ended by itself");
      }
      module
          .answer()
          .sentence(
              Map.of("module", listing.path(), "lease", found.id(), "revoked", true),
              "Revoked lease "
                  + found.shortId()
                  + " on "
                  + listing.path()
                  + ", held from "
                  + found.hostInWords()
                  + ".");
      return ExitCode.SUCCESS;
    }
  }

  private LeaseView find(String path, List<LeaseStatus> leases) {
    List<LeaseView> found =
        leases.stream()
            .map(each -> LeaseView.of(path, each))
            .filter(each -> !lease.isEmpty() && each.id().toString().startsWith(lease))
            .toList();
    if (found.size() == 1) {
      return found.get(0);
    }
    throw new CommandFailure(
        ExitCode.NOT_FOUND,
        found.isEmpty()
            ? "there is no lease " + lease + " on " + path + "; ./dfra lease list shows all"
            : "several leases on "
                + path
                + " begin so: "
                + found.stream().map(each -> each.id().toString()).collect(Collectors.joining(", "))
                + "; write more of the one");
  }
}
