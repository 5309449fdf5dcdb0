package org.dfra.river.proxy;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import java.util.ArrayList;
import java.util.Iterator;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import net.jini.core.lease.Lease;
import org.dfra.river.remote.ProcessLease;

/**
 * The renewers of this virtual machine, grouped by landlord: the leases of a group can be renewed
 * in one call. Thread-safe.
 */
final class RenewalGroups {

  /** Those of this virtual machine. */
  static final RenewalGroups SHARED = new RenewalGroups();

  @GuardedBy("this")
  private final List<RenewalGroup> groups = new ArrayList<>();

  /** The renewers of one landlord's leases. */
  private static final class RenewalGroup {
    final Lease first; // also when it has ended: it shows the landlord
    final Set<LeaseRenewer> members = new LinkedHashSet<>(); // guarded by the groups

    RenewalGroup(Lease first) {
      this.first = first;
    }
  }

  /** Adds a renewer to the group of its lease, if that is a {@link ProcessLease}. */
  synchronized void join(LeaseRenewer renewer, Lease lease) {
    if (!(lease instanceof ProcessLease)) {
      return; // others group by an ID that the landlord chooses, and their code is not ours
    }
    for (RenewalGroup each : groups) {
      if (each.first.canBatch(lease)) {
        each.members.add(renewer);
        return;
      }
    }
    RenewalGroup fresh = new RenewalGroup(lease);
    fresh.members.add(renewer);
    groups.add(fresh);
  }

  /** Removes a renewer from its group. */
  synchronized void leave(LeaseRenewer renewer) {
    for (Iterator<RenewalGroup> each = groups.iterator(); each.hasNext(); ) {
      RenewalGroup group = each.next();
      if (group.members.remove(renewer) && group.members.isEmpty()) {
        each.remove();
      }
    }
  }

  /** The other members of a renewer's group. */
  synchronized List<LeaseRenewer> others(LeaseRenewer renewer) {
    for (RenewalGroup each : groups) {
      if (each.members.contains(renewer)) {
        return each.members.stream().filter(other -> other != renewer).toList();
      }
    }
    return List.of();
  }
}
