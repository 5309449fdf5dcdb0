package org.dfra.core.module;

import java.time.Instant;
import java.util.Optional;
import java.util.UUID;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.BooleanSupplier;
import org.dfra.core.event.EventHub;
import org.dfra.core.lease.LeaseRegistry;
import org.dfra.event.DeliveryPolicy;
import org.dfra.event.ModuleListener;
import org.dfra.event.Subscription;
import org.dfra.event.delivery.DeliveryCounter;
import org.dfra.event.delivery.ListenerQueue;
import org.dfra.lease.LeaseRefusedException;
import org.dfra.lifecycle.Readiness;
import org.jspecify.annotations.Nullable;

/**
 * A module's listeners in its own virtual machine. Each holds a lease without renewal, by which it
 * is counted, until it closes its subscription or the lease is revoked.
 */
final class LocalListeners {

  private final EventHub events;
  private final LeaseRegistry leases;
  private final Lifecycle lifecycle;

  /**
   * @param events the module's events
   * @param leases the module's leases
   * @param lifecycle the module's lifecycle
   */
  LocalListeners(EventHub events, LeaseRegistry leases, Lifecycle lifecycle) {
    this.events = events;
    this.leases = leases;
    this.lifecycle = lifecycle;
  }

  /** Adds a listener. One that is added after the module's end receives no events. */
  Subscription add(ModuleListener listener, DeliveryPolicy policy) {
    DeliveryCounter counter = new DeliveryCounter(listener);
    EventHub.ListenerEntry entry =
        events.add(counter, policy, ListenerQueue.NEVER_GIVE_UP, () -> {});
    counter.startAfter(entry.lastSequences());
    @Nullable UUID lease;
    try {
      lease = leases.grantLocal(ModuleImpl.leaseRole(policy), () -> revoked(entry));
    } catch (LeaseRefusedException e) { // it has ended, and publishes no more events
      lease = null;
    }
    @Nullable UUID held = lease;
    return new LocalSubscription(
        counter,
        () -> held != null && leases.contains(held),
        () -> {
          events.remove(entry);
          if (held != null) {
            boolean unused = leases.cancel(held);
          }
        });
  }

  /** A listener's lease was revoked. At the module's own end it still receives that event. */
  private void revoked(EventHub.ListenerEntry entry) {
    if (lifecycle.readiness() != Readiness.STOPPED) {
      events.remove(entry);
    }
  }

  /** The subscription of a listener in the module's own virtual machine. */
  private static final class LocalSubscription implements Subscription {

    private final DeliveryCounter counter;
    private final BooleanSupplier held;
    private final Runnable end;
    private final AtomicBoolean closed = new AtomicBoolean();

    /**
     * @param held whether the listener's lease is still live
     * @param end run once when it is closed
     */
    LocalSubscription(DeliveryCounter counter, BooleanSupplier held, Runnable end) {
      this.counter = counter;
      this.held = held;
      this.end = end;
    }

    @Override
    public long received() {
      return counter.received();
    }

    @Override
    public long lost() {
      return counter.lost();
    }

    @Override
    public Optional<Instant> interruptedSince() {
      return Optional.empty();
    }

    @Override
    public boolean isOpen() {
      return !closed.get() && held.getAsBoolean();
    }

    @Override
    public void close() {
      if (closed.compareAndSet(false, true)) {
        end.run();
      }
    }
  }
}
