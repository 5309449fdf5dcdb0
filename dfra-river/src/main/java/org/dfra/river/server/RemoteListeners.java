package org.dfra.river.server;

import java.util.HashMap;
import java.util.Map;
import java.util.UUID;
import java.util.stream.LongStream;
import net.jini.core.lease.Lease;
import org.dfra.core.event.EventHub;
import org.dfra.core.module.ModuleImpl;
import org.dfra.event.DeliveryPolicy;
import org.dfra.event.ModuleListener;
import org.dfra.lease.LeaseRefusedException;
import org.dfra.module.NotReadyException;
import org.dfra.river.lease.ModuleLandlord;
import org.dfra.river.remote.LeasedSubscription;
import org.dfra.river.remote.RemoteModuleListener;
import org.jspecify.annotations.Nullable;

/**
 * The remote listeners of one module. Each has a lease and a place at the module's hub; it loses
 * both when its client closes the subscription, when the lease has expired, when {@value #FAILURES}
 * deliveries in a row have failed, or when it turns out to be gone.
 */
final class RemoteListeners {

  /** At a deadline of 2 s each, that is six seconds of silence. */
  private static final int FAILURES = 3;

  private final ModuleImpl driver;
  private final ModuleLandlord landlord;
  private final Map<ModuleListener, Registered> registered = new HashMap<>(); // guarded by this

  RemoteListeners(ModuleImpl driver, ModuleLandlord landlord) {
    this.driver = driver;
    this.landlord = landlord;
  }

  /** One listener's lease and place. */
  private static final class Registered {
    final ModuleListener listener;
    EventHub.@Nullable Entry entry; // guarded by the listeners
    @Nullable UUID lease; // guarded by the listeners

    Registered(ModuleListener listener) {
      this.listener = listener;
    }
  }

  synchronized LeasedSubscription add(ModuleListener listener, DeliveryPolicy policy) {
    if (!(listener instanceof RemoteModuleListener)) {
      throw new IllegalArgumentException(
          driver.identification().path()
              + " cannot tell a "
              + listener.getClass().getSimpleName()
              + ", which is no RemoteModuleListener; subscribe through the module's proxy");
    }
    Registered before = registered.get(listener);
    if (before != null) {
      remove(before);
    }
    Registered now = new Registered(listener);
    Lease lease;
    try {
      Runnable gone = () -> remove(now); // also where the client gives the lease back
      lease = landlord.grant(Lease.ANY, ModuleImpl.holder(policy), gone, gone);
    } catch (LeaseRefusedException e) {
      throw new NotReadyException(
          driver.identification().path(), driver.readiness(), String.valueOf(e.getMessage()));
    }
    now.lease = ModuleLandlord.id(lease);
    EventHub.Entry entry = driver.events().add(listener, policy, FAILURES, () -> remove(now));
    now.entry = entry;
    registered.put(listener, now);
    return new LeasedSubscription(
        lease, entry.epoch(), LongStream.of(entry.numbers()).boxed().toList());
  }

  /** Also for one that is being removed: ending its lease leads here again, and to nothing. */
  private synchronized void remove(Registered gone) {
    boolean unused = registered.remove(gone.listener, gone);
    if (gone.entry != null) {
      driver.events().remove(gone.entry);
    }
    if (gone.lease != null) {
      boolean ended = driver.leases().cancel(gone.lease);
    }
  }
}
