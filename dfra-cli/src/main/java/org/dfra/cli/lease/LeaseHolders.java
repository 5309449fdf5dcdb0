package org.dfra.cli.lease;

import java.time.Duration;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import org.dfra.cli.team.Administration;
import org.dfra.cli.team.DuplicateRobotNames;
import org.dfra.cli.team.ParallelQuery;
import org.dfra.directory.ModuleListing;
import org.dfra.lease.LeaseHandle;
import org.dfra.module.Module;

/** Which modules hold which leases: each module is queried for the leases held in its process. */
final class LeaseHolders {

  private final Map<LeaseHandle, Set<String>> modules = new HashMap<>();

  /** Adds one module's answer. */
  LeaseHolders add(String module, Set<LeaseHandle> leases) {
    leases.forEach(each -> modules.computeIfAbsent(each, key -> new TreeSet<>()).add(module));
    return this;
  }

  /** The modules of the process that holds a lease; none if no module is known to hold it. */
  List<String> of(LeaseHandle lease) {
    return List.copyOf(modules.getOrDefault(lease, Set.of()));
  }

  /**
   * Queries all modules of a list in parallel. Omits modules that do not answer, or do not support
   * the query since their version is older.
   *
   * @param deadline timeout for all answers together
   */
  static LeaseHolders query(List<ModuleListing<Module>> all, Duration deadline)
      throws InterruptedException {
    List<ModuleListing<Module>> asked = all.stream().filter(each -> !each.stale()).toList();
    List<Set<LeaseHandle>> held =
        ParallelQuery.ask(
            asked,
            each -> () -> Administration.of(each).heldLeases(),
            cause -> Set.of(), // the address of the leases' holder is shown instead
            deadline);
    LeaseHolders holders = new LeaseHolders();
    for (int i = 0; i < held.size(); i++) {
      holders.add(DuplicateRobotNames.displayPath(asked.get(i), all), held.get(i));
    }
    return holders;
  }
}
