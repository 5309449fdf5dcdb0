package org.dfra.app.lease;

import java.rmi.RemoteException;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.Callable;
import org.dfra.app.team.Administration;
import org.dfra.app.team.DuplicateRobotNames;
import org.dfra.app.team.LastSeen;
import org.dfra.app.team.TeamDirectory;
import org.dfra.app.team.TeamOptions;
import org.dfra.app.team.UnansweredCall;
import org.dfra.app.terminal.ExitCode;
import org.dfra.app.terminal.Table;
import org.dfra.directory.ModuleListing;
import org.dfra.directory.ModuleQuery;
import org.dfra.lease.LeaseStatus;
import org.dfra.module.Module;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Parameters;

/** {@code ./dfra lease list}. */
@Command(
    name = "list",
    description = "Lists who holds leases on a module, or on all of the team's.",
    footer = {
      "",
      "Clients make a module work, watchers only watch it; an effector obeys its commander.",
      "A lease expires unless its holder renews it; one held in the module's own JVM lasts",
      "as long as the module."
    })
final class LeaseListCommand implements Callable<Integer> {

  @Parameters(
      index = "0",
      arity = "0..1",
      paramLabel = "ROBOT/MODULE",
      description = "Only those on this module.")
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
        } catch (RemoteException | RuntimeException | LinkageError e) { // also from a foreign proxy
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
    Table table = new Table("MODULE", "AS", "HELD BY", "SINCE", "EXPIRES", "LEASE");
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
