package org.dfra.core.event;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import java.time.InstantSource;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.Executor;
import org.dfra.core.state.StateStore;
import org.dfra.event.Delivery;
import org.dfra.event.DeliveryPolicy;
import org.dfra.event.DeliveryPolicy.EventKind;
import org.dfra.event.ModuleEvent;
import org.dfra.event.ModuleListener;
import org.dfra.event.delivery.BatchLimits;
import org.dfra.event.delivery.BatchListener;
import org.dfra.event.delivery.DeliveryPool;
import org.dfra.event.delivery.ListenerQueue;
import org.dfra.time.Scheduler;

/**
 * Distributes a module's events to all its listeners. Publishing never waits for a listener and
 * allocates one {@link Delivery}, which all listeners share.
 */
public final class EventHub {

  private final String module;
  private final InstantSource clock;
  private final DeliveryPool pool;
  private final Scheduler scheduler;

  @GuardedBy("this")
  private final EventSequences numbers;

  private final List<ListenerEntry> entries = new CopyOnWriteArrayList<>();

  /**
   * @param module the module's path, {@code robot/name}
   * @param clock stamps the events
   * @param state stores their sequence numbers
   */
  public EventHub(
      String module,
      InstantSource clock,
      StateStore state,
      DeliveryPool pool,
      Scheduler scheduler) {
    this.module = module;
    this.clock = clock;
    this.numbers = new EventSequences(state, clock);
    this.pool = pool;
    this.scheduler = scheduler;
  }

  /**
   * The registration of one listener.
   *
   * @param epoch the module's epoch at registration
   * @param lastSequences the last sequence number of each kind of event at registration, by ordinal
   */
  public record ListenerEntry(ListenerQueue queue, long epoch, long[] lastSequences) {}

  /**
   * Adds a listener. Every event published from now on is offered to it.
   *
   * @param failuresAllowed it is removed after this many consecutive failures; {@link
   *     ListenerQueue#NEVER_GIVE_UP} for a listener in this virtual machine
   * @param whenGivenUp run once when that happens
   */
  public ListenerEntry add(
      ModuleListener listener, DeliveryPolicy policy, int failuresAllowed, Runnable whenGivenUp) {
    return add(listener, policy, failuresAllowed, whenGivenUp, pool);
  }

  /**
   * The same, for a listener that is notified on other threads than those of this hub's pool.
   *
   * @param deliveries runs each delivery; it drops none. In lock-step the hub's pool is used
   *     instead, since all work must run on the scheduler
   */
  public ListenerEntry add(
      ModuleListener listener,
      DeliveryPolicy policy,
      int failuresAllowed,
      Runnable whenGivenUp,
      Executor deliveries) {
    return add(
        new ListenerQueue(
            listener, policy, failuresAllowed, givenUp(whenGivenUp), pool(deliveries), scheduler));
  }

  /**
   * The same, for a listener that is notified of several events at once.
   *
   * @param limits of the events in one call
   */
  public ListenerEntry add(
      BatchListener listener,
      BatchLimits limits,
      DeliveryPolicy policy,
      int failuresAllowed,
      Runnable whenGivenUp,
      Executor deliveries) {
    return add(
        new ListenerQueue(
            listener,
            limits,
            policy,
            failuresAllowed,
            givenUp(whenGivenUp),
            pool(deliveries),
            scheduler));
  }

  private Runnable givenUp(Runnable then) {
    return () -> {
      entries.removeIf(entry -> !entry.queue().isOpen());
      then.run();
    };
  }

  private Executor pool(Executor deliveries) {
    return scheduler.isLockStep() ? pool : deliveries;
  }

  private ListenerEntry add(ListenerQueue queue) {
    synchronized (this) {
      ListenerEntry entry = new ListenerEntry(queue, numbers.epoch(), numbers.last());
      entries.add(entry);
      return entry;
    }
  }

  /** Removes a listener. */
  public void remove(ListenerEntry entry) {
    entries.remove(entry);
    entry.queue().close();
  }

  /** The registered listeners. */
  public List<ListenerEntry> entries() {
    return List.copyOf(entries);
  }

  /** Numbers an event and offers it to all listeners. */
  public void publish(ModuleEvent event) {
    synchronized (this) { // held while offering too, so that all listeners see the same order
      Delivery delivery =
          new Delivery(
              module,
              numbers.epoch(),
              numbers.next(EventKind.of(event)),
              0,
              clock.instant(),
              event);
      for (ListenerEntry entry : entries) {
        entry.queue().offer(delivery);
      }
    }
  }
}
