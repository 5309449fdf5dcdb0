package org.dfra.core.module;

import java.util.UUID;
import org.dfra.core.event.EventHub;
import org.dfra.core.lease.LeaseBook;
import org.dfra.event.DeliveryPolicy;
import org.dfra.event.ModuleListener;
import org.dfra.event.Subscription;
import org.dfra.event.delivery.ListenerQueue;
import org.dfra.event.delivery.Tally;
import org.dfra.lease.LeaseRefusedException;
import org.dfra.module.Readiness;
import org.jspecify.annotations.Nullable;

/**
 * A module's listeners in its own virtual machine. Each holds a lease that nobody need renew, by
 * which it is counted, until it closes its subscription or the lease is ended for it.
 */
final class LocalListeners {

  private final EventHub events;
  private final LeaseBook leases;
  private final Lifecycle lifecycle;

  /**
   * @param events the module's
   * @param leases the module's
   * @param lifecycle the module's
   */
  LocalListeners(EventHub events, LeaseBook leases, Lifecycle lifecycle) {
    this.events = events;
    this.leases = leases;
    this.lifecycle = lifecycle;
  }

  /** Adds a listener. One that comes after the module's end is added too, and hears nothing. */
  Subscription add(ModuleListener listener, DeliveryPolicy policy) {
    Tally tally = new Tally(listener);
    EventHub.Entry entry = events.add(tally, policy, ListenerQueue.NEVER, () -> {});
    tally.begin(entry.numbers());
    @Nullable UUID lease;
    try {
      lease = leases.hold(ModuleImpl.holder(policy), () -> revoked(entry));
    } catch (LeaseRefusedException e) { // it has ended, and will not tell anything any more
      lease = null;
    }
    @Nullable UUID held = lease;
    return new LocalSubscription(
        tally,
        () -> held != null && leases.holds(held),
        () -> {
          events.remove(entry);
          if (held != null) {
            boolean unused = leases.cancel(held);
          }
        });
  }

  /** A listener's lease was ended for it. Of the module's own end it still hears. */
  private void revoked(EventHub.Entry entry) {
    if (lifecycle.readiness() != Readiness.STOPPED) {
      events.remove(entry);
    }
  }
}
