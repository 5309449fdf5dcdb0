package org.dfra.river.proxy;

import java.util.Set;
import java.util.UUID;
import java.util.concurrent.ConcurrentHashMap;
import net.jini.core.lease.Lease;
import net.jini.id.ReferentUuid;
import net.jini.id.Uuid;
import org.dfra.lease.LeaseHandle;

/**
 * The leases that this virtual machine holds on remote modules, by the handles under which these
 * modules list them. So an administrator can match a lease to the modules that hold it. The leases'
 * IDs are secrets and are not published.
 */
public final class HeldLeaseRegistry {

  private static final Set<LeaseHandle> HELD = ConcurrentHashMap.newKeySet();

  private HeldLeaseRegistry() {}

  /** The handles of all leases that are held now. */
  public static Set<LeaseHandle> all() {
    return Set.copyOf(HELD);
  }

  static void add(Lease lease) {
    if (lease instanceof ReferentUuid named) {
      HELD.add(handle(named.getReferentUuid()));
    }
  }

  static void remove(Lease lease) {
    if (lease instanceof ReferentUuid named) {
      HELD.remove(handle(named.getReferentUuid()));
    }
  }

  private static LeaseHandle handle(Uuid id) {
    return LeaseHandle.of(new UUID(id.getMostSignificantBits(), id.getLeastSignificantBits()));
  }
}
