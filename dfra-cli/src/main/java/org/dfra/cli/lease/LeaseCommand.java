package org.dfra.cli.lease;

import java.rmi.RemoteException;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.concurrent.Callable;
import java.util.stream.Collectors;
import org.dfra.cli.team.Administration;
import org.dfra.cli.team.DuplicateRobotNames;
import org.dfra.cli.team.LastSeen;
import org.dfra.cli.team.ModuleArgument;
import org.dfra.cli.team.TeamDirectory;
import org.dfra.cli.team.TeamOptions;
import org.dfra.cli.team.UnansweredCall;
import org.dfra.core.host.CommandName;
import org.dfra.directory.ModuleListing;
import org.dfra.directory.ModuleQuery;
import org.dfra.lease.LeaseHandle;
import org.dfra.lease.LeaseStatus;
import org.dfra.module.Module;
import org.dfra.report.terminal.CommandFailure;
import org.dfra.report.terminal.ExitCode;
import org.dfra.report.terminal.Table;
import org.dfra.river.remote.ModuleAdmin;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Parameters;

/** {@code ./dfra lease}: leases on modules and their holders. */
@Command(
    name = "lease",
    description = "Shows who holds leases on the team's modules, and revokes leases.",
    synopsisSubcommandLabel = "COMMAND",
    commandListHeading = "%nCommands:%n",
    subcommands = {LeaseCommand.LeaseListCommand.class, LeaseCommand.RevokeCommand.class})
public final class LeaseCommand {

  /** {@code ./dfra lease revoke}. */
  @Command(
      name = "revoke",
      description = "Ends a lease before it expires, without its holder's consent.",
      footer = {
        "",
        "Its holder learns of this at its next renewal, within a second, and does not register",
        "again automatically. It may request a new lease."
      })
  static final class RevokeCommand implements Callable<Integer> {

    @Mixin
    @SuppressWarnings("NullAway.Init") // set by picocli before the call
    private ModuleArgument module;

    @Parameters(
        index = "1",
        paramLabel = "LEASE",
        description =
            "The lease, or the beginning of its name; "
                + CommandName.IN_HELP
                + " lease list shows it.")
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
              ? "there is no lease "
                  + lease
                  + " on "
                  + path
                  + "; "
                  + CommandName.current()
                  + " lease list shows all"
              : "several leases on "
                  + path
                  + " begin so: "
                  + found.stream()
                      .map(each -> each.id().toString())
                      .collect(Collectors.joining(", "))
                  + "; write more of the one");
    }
  }

  /** {@code ./dfra lease list}. */
  @Command(
      name = "list",
      description = "Lists who holds leases on a module, or on all modules of the team.",
      footer = {
        "",
        "A client makes the module work, a watcher only observes it, and an effector executes",
        "the commands of its commander. A lease expires unless its holder renews it; a lease",
        "held in the module's own JVM never expires while the module runs."
      })
  static final class LeaseListCommand implements Callable<Integer> {

    @Parameters(
        index = "0",
        arity = "0..1",
        paramLabel = "ROBOT/MODULE",
        description = "Only the leases on this module.")
    private @Nullable String module;

    /** Timeout for modules to report the leases they hold. */
    private static final Duration ANSWERS = Duration.ofSeconds(2);

    @Mixin
    @SuppressWarnings("NullAway.Init") // set by picocli before the call
    private TeamOptions options;

    @Override
    public Integer call() throws Exception {
      try (TeamDirectory team = options.open()) {
        List<LeaseView> leases = new ArrayList<>();
        int silent = 0;
        List<ModuleListing<Module>> all = all(team);
        LeaseHolders holders = LeaseHolders.query(all, ANSWERS);
        for (ModuleListing<Module> each : asked(team)) {
          String path = DuplicateRobotNames.displayPath(each, all);
          try {
            for (LeaseStatus lease : Administration.of(each).leases()) {
              leases.add(LeaseView.of(path, lease, holders.of(lease.handle())));
            }
          } catch (RemoteException
              | RuntimeException
              | LinkageError e) { // also from a foreign proxy
            if (module != null) {
              throw e;
            }
            silent++;
            options.answer().note(UnansweredCall.inWords(path, e));
          }
        }
        show(leases);
        return silent == 0 ? ExitCode.SUCCESS : ExitCode.NO_ANSWER;
      }
    }

    private List<ModuleListing<Module>> asked(TeamDirectory team) throws InterruptedException {
      return module != null ? List.of(team.module(module)) : all(team);
    }

    private static List<ModuleListing<Module>> all(TeamDirectory team) throws InterruptedException {
      return team.awaitDirectory().find(ModuleQuery.of(Module.class)).stream()
          .sorted(Comparator.comparing(ModuleListing<Module>::path))
          .toList();
    }

    private void show(List<LeaseView> leases) {
      Table table = new Table("MODULE", "ROLE", "HELD BY", "SINCE", "EXPIRES", "LEASE");
      for (LeaseView each : leases) {
        table.row(
            each.module(),
            each.holder().name().toLowerCase(Locale.ROOT),
            each.holderInWords(),
            LastSeen.formatSpan(each.held()) + " ago",
            each.endInWords(),
            each.shortId());
      }
      options
          .answer()
          .table(
              leases,
              table,
              module == null ? "Nobody holds a lease." : "Nobody holds a lease on " + module + ".");
    }
  }
}
