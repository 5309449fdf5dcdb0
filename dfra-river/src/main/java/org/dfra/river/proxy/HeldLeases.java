package org.dfra.river.proxy;

import java.util.Set;
import java.util.UUID;
import java.util.concurrent.ConcurrentHashMap;
import net.jini.core.lease.Lease;
import net.jini.id.ReferentUuid;
import net.jini.id.Uuid;

/**
 * The leases that this virtual machine holds on modules elsewhere, by the identities that these
 * modules give them: so whoever asks who holds a lease learns which modules it is held with.
 */
public final class HeldLeases {

  private static final Set<UUID> HELD = ConcurrentHashMap.newKeySet();

  private HeldLeases() {}

  /** All that are held now. */
  public static Set<UUID> all() {
    return Set.copyOf(HELD);
  }

  static void add(Lease lease) {
    if (lease instanceof ReferentUuid named) {
      HELD.add(id(named.getReferentUuid()));
    }
  }

  static void remove(Lease lease) {
    if (lease instanceof ReferentUuid named) {
      HELD.remove(id(named.getReferentUuid()));
    }
  }

  private static UUID id(Uuid id) {
    return new UUID(id.getMostSignificantBits(), id.getLeastSignificantBits());
  }
}
