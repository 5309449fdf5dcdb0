package org.dfra.river.lookup;

import java.io.IOException;
import java.rmi.MarshalledObject;
import java.rmi.RemoteException;
import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.util.Collection;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import net.jini.core.event.EventRegistration;
import net.jini.core.event.RemoteEvent;
import net.jini.core.event.RemoteEventListener;
import net.jini.core.lease.LeaseDeniedException;
import net.jini.core.lease.UnknownLeaseException;
import net.jini.core.lookup.ServiceEvent;
import net.jini.core.lookup.ServiceID;
import net.jini.core.lookup.ServiceItem;
import net.jini.core.lookup.ServiceRegistrar;
import net.jini.core.lookup.ServiceTemplate;
import net.jini.export.Exporter;
import org.dfra.river.call.CallThreads;
import org.dfra.river.discovery.LocatedRegistrar;
import org.dfra.river.lookup.RegistrarContents.RegistrarCall;
import org.dfra.river.transport.ServerNotAcceptedException;
import org.dfra.security.AccessRefusedException;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Tracks the contents of one lookup service by its events and by a heartbeat.
 *
 * <p>Everything is read again only if there is a reason: an event's number is missing, there were
 * more events than the queue takes, the lookup service did not answer for a while or lost the
 * registration for events, or it holds another number of services than the events say. The last one
 * is compared at every {@link DirectorySettings#reconcileInterval}, by a call that returns no
 * service. Only a change of attributes can be lost without any of these signs, and only if no event
 * follows; so each {@value #COMPLETE_EVERY}th of these times everything is read without a reason.
 *
 * <p>Threads: daemons, {@code dfra-registrar-n}, one while there is something to do. It makes every
 * call to the lookup service. If such a call hangs, it blocks only this thread; {@link #check}, on
 * the directory's own thread, detects it. Between heartbeats a monitor has no thread, so that their
 * number does not grow with the number of lookup services.
 */
final class RegistrarMonitor implements AutoCloseable {

  private static final Logger LOG = LoggerFactory.getLogger(RegistrarMonitor.class);

  private static final int TRANSITIONS =
      ServiceRegistrar.TRANSITION_MATCH_MATCH
          | ServiceRegistrar.TRANSITION_MATCH_NOMATCH
          | ServiceRegistrar.TRANSITION_NOMATCH_MATCH;

  /** The limit of waiting events; beyond it a complete query replaces them. */
  private static final int LONGEST_QUEUE = 10_000;

  /** See the class comment. */
  static final int COMPLETE_EVERY = 20;

  private static final ThreadPoolExecutor THREADS = threads();

  private static final int UNKNOWN = -1;

  private static final int IDLE_SECONDS = 5;

  private final LocatedRegistrar identity;
  private final ServiceRegistrar registrar; // the same, for calls
  private final RegistrarContents contents;
  private final ServiceTable serviceTable;
  private final DirectorySettings settings;
  private final InstantSource clock;
  private final Exporter exporter;
  private final Runnable reader;
  private final Consumer<RegistrarMonitor> end;
  private final BlockingQueue<ServiceEvent> events = new LinkedBlockingQueue<>(LONGEST_QUEUE);

  /** A strong reference, since JERI holds what it exports weakly. */
  private final ServiceEventListener listener = new ServiceEventListener();

  private final PooledWorker worker;
  private volatile boolean read; // complete, at least once
  private volatile boolean incomplete = true; // an event or item was missed
  private volatile Instant vouched;
  private volatile long busySince; // System.nanoTime of the running call; 0 for none

  /** How many heartbeats lie between two readings of a lookup service that sends no events. */
  private static final int BEATS_WITHOUT_EVENTS = 5;

  private volatile boolean silent;
  private volatile @Nullable String refusal; // why it and this program do not accept each other
  private final TeamNeighbours neighbours = new TeamNeighbours(); // by the worker
  private final Map<ServiceID, String> faults = new HashMap<>(); // of proxies; by the worker
  private @Nullable RemoteEventListener stub; // by the worker
  private @Nullable EventRegistration registration; // by the worker
  private long sequence; // by the worker
  private int services = UNKNOWN; // how many it holds by its events; by the worker
  private boolean isRefused; // whether it sends this program no events; by the worker
  private boolean isOtherCount; // at the last comparison; by the worker
  private int comparisons; // since the last complete query; by the worker
  private long compareAt; // System.nanoTime; by the worker
  private boolean located; // whether its host was read; by the worker
  private long beaten = System.nanoTime(); // when the last heartbeat was sent; by the worker

  /**
   * @param exporter exports the listener while the monitor runs
   * @param reader is notified when everything was read, on the monitor's thread
   * @param end is notified when the lookup service has failed and the monitor has ended
   */
  RegistrarMonitor(
      LocatedRegistrar identity,
      ServiceTable serviceTable,
      DirectorySettings settings,
      InstantSource clock,
      Exporter exporter,
      Runnable reader,
      Consumer<RegistrarMonitor> end) {
    this.identity = identity;
    this.registrar = identity;
    this.contents = new RegistrarContents(identity, this::call);
    this.serviceTable = serviceTable;
    this.settings = settings;
    this.clock = clock;
    this.exporter = exporter;
    this.reader = reader;
    this.end = end;
    this.vouched = clock.instant();
    this.worker = new PooledWorker(identity, THREADS, new MonitorWork());
  }

  private static ThreadPoolExecutor threads() {
    ThreadPoolExecutor threads = CallThreads.pool("dfra-registrar-");
    threads.setKeepAliveTime(IDLE_SECONDS, TimeUnit.SECONDS); // several heartbeats
    return threads;
  }

  void start() {
    worker.wake();
  }

  LocatedRegistrar registrar() {
    return identity;
  }

  /** Why it has ended, if the lookup service and this program do not accept each other. */
  Optional<String> refusal() {
    return Optional.ofNullable(refusal);
  }

  /** Whether its contents were read completely once. */
  boolean isRead() {
    return read;
  }

  /** Detects a lookup service that does not answer, or takes long to be read. */
  void check(long nanos) {
    // The others do not wait longer for it, whatever it does meanwhile.
    ReadPermits.SHARED.releaseAfter(this, settings.registrarTimeout().toNanos() / 3);
    long since = busySince;
    if (since != 0 && nanos - since > settings.registrarTimeout().toNanos() && !silent) {
      silent = true;
      LOG.warn("Lookup service {} does not answer; what it holds is stale.", identity);
      serviceTable.markOutOfReach(identity, vouched);
    }
  }

  private void end(@Nullable Exception failure) {
    boolean closed = worker.isClosed();
    if (failure != null && !closed) {
      LOG.info("Lookup service {} is out of reach: {}", identity, failure.toString());
      refusal = ServerNotAcceptedException.reason(failure).orElse(null);
    }
    ReadPermits.SHARED.release(this);
    if (closed) {
      cancel();
    }
    if (stub != null) {
      exporter.unexport(true);
    }
    busySince = 0;
    if (!closed) {
      serviceTable.markOutOfReach(identity, vouched);
      end.accept(this);
    }
  }

  private void step() throws IOException {
    if (stub == null) {
      stub = (RemoteEventListener) exporter.export(listener);
    }
    if (registration == null && !isRefused) {
      register(stub);
    }
    if (incomplete) {
      if (!ReadPermits.SHARED.acquire(this, identity.address(), worker::wake)) {
        beatIfDue();
        return;
      }
      try {
        reconcile();
      } finally {
        ReadPermits.SHARED.release(this);
      }
    }
    for (ServiceEvent event; !worker.isClosed() && (event = events.poll()) != null; ) {
      take(event);
      beatIfDue();
    }
    beatIfDue();
    if (isRefused && System.nanoTime() - compareAt > 0) {
      incomplete = true;
    }
    if (incomplete || (registration == null && !isRefused)) {
      worker.wake();
    } else if (isRefused) {
      return; // it is read again later
    } else if (services == UNKNOWN) {
      services = contents.count(); // with no event waiting that would be counted once more
    } else if (System.nanoTime() - compareAt > 0) {
      compare(); // likewise
    }
  }

  /** By time: if events come faster than heartbeats, the event lease must still be renewed. */
  private void beatIfDue() throws RemoteException {
    if (age(beaten).compareTo(settings.heartbeatInterval()) >= 0) {
      beaten = System.nanoTime();
      beat();
    }
  }

  private static Duration age(long since) {
    return Duration.ofNanos(System.nanoTime() - since);
  }

  private void register(RemoteEventListener stub) throws RemoteException {
    events.clear();
    try {
      registerFor(stub);
    } catch (AccessRefusedException e) { // a stranger may read, and gets no events
      isRefused = true;
      LOG.info("{} sends no events: {}", identity, e.getMessage());
    }
    incomplete = true;
  }

  private void registerFor(RemoteEventListener stub) throws RemoteException {
    EventRegistration begun =
        call(
            () ->
                registrar.notify(
                    new ServiceTemplate(null, null, null),
                    TRANSITIONS,
                    stub,
                    (MarshalledObject<?>) null,
                    settings.eventLease().toMillis()));
    registration = begun;
    sequence = begun.getSequenceNumber();
  }

  /** Reads everything. Later changes come as events. */
  private void reconcile() throws RemoteException {
    if (silent) {
      int unused = contents.count(); // it answers again
    }
    incomplete = false;
    services = UNKNOWN;
    Map<ServiceID, ServiceItem> items = contents.items();
    locate();
    neighbours.replaceAll(items.values());
    faults.keySet().retainAll(items.keySet());
    // Publish usable services before the search for faults of the others.
    serviceTable.replaceAll(identity, items.values(), faults);
    findFaults(items.values());
    compareAfter(
        isRefused
            ? settings.heartbeatInterval().multipliedBy(BEATS_WITHOUT_EVENTS)
            : settings.reconcileInterval());
    comparisons = 0;
    isOtherCount = false;
    read = true;
    neighbours.exchangeNews();
    reader.run();
  }

  /**
   * Compares the number of its services with that of the events. An event may be on its way; so
   * only two differences in a row mean that one was lost.
   */
  private void compare() throws RemoteException {
    if (++comparisons % COMPLETE_EVERY == 0) {
      incomplete = true;
      worker.wake();
      return;
    }
    boolean isOther = contents.count() != services;
    if (isOther && isOtherCount) {
      LOG.debug("Events of {} were lost: everything is read.", identity);
      incomplete = true;
      worker.wake();
      return;
    }
    isOtherCount = isOther;
    compareAfter(isOther ? settings.heartbeatInterval() : settings.reconcileInterval());
  }

  private void compareAfter(Duration interval) {
    compareAt = System.nanoTime() + interval.toNanos();
  }

  /** Reads once which computer it runs on. */
  private void locate() throws RemoteException {
    if (!located) {
      contents.host().ifPresent(host -> serviceTable.setHost(identity, host));
      located = true;
    }
  }

  /** Determines why proxies could not be read, unless this is known. */
  private void findFaults(Collection<ServiceItem> items) throws RemoteException {
    for (ServiceItem item : items) {
      if (item.service != null) {
        faults.remove(item.serviceID);
      } else if (!faults.containsKey(item.serviceID)) {
        Optional<String> fault = contents.fault(item.serviceID);
        if (fault.isPresent()) {
          faults.put(item.serviceID, fault.get());
          serviceTable.update(identity, item, fault.get());
        }
      }
    }
  }

  private void take(ServiceEvent event) throws RemoteException {
    EventRegistration known = registration;
    if (known == null || event.getID() != known.getID()) {
      return; // of an earlier registration
    }
    long next = event.getSequenceNumber();
    if (next != sequence + 1) {
      incomplete = true;
    }
    sequence = Math.max(sequence, next);
    if (services != UNKNOWN) {
      services += change(event.getTransition());
    }
    if (event.getTransition() == ServiceRegistrar.TRANSITION_MATCH_NOMATCH) {
      serviceTable.remove(identity, ServiceTable.uuid(event.getServiceID()));
      return;
    }
    @Nullable ServiceItem item = event.getServiceItem();
    if (item == null) {
      return;
    }
    neighbours.add(item);
    Optional<String> fault =
        item.service == null ? contents.fault(item.serviceID) : Optional.empty();
    if (fault.isPresent()) {
      faults.put(item.serviceID, fault.get());
      serviceTable.update(identity, item, fault.get());
    } else {
      faults.remove(item.serviceID);
      serviceTable.update(identity, item);
    }
  }

  private static int change(int transition) {
    return switch (transition) {
      case ServiceRegistrar.TRANSITION_NOMATCH_MATCH -> 1;
      case ServiceRegistrar.TRANSITION_MATCH_NOMATCH -> -1;
      default -> 0;
    };
  }

  /** Sends a heartbeat, which renews the event lease. */
  private void beat() throws RemoteException {
    neighbours.exchangeNews();
    EventRegistration known = registration;
    if (known == null) {
      return;
    }
    try {
      call(
          () -> {
            try {
              known.getLease().renew(settings.eventLease().toMillis());
              return true;
            } catch (LeaseDeniedException e) {
              throw new UnknownLeaseException(e.getMessage());
            }
          });
    } catch (UnknownLeaseException e) {
      registration = null; // it was restarted without its event registrations
    }
  }

  private <T extends @Nullable Object, E extends Exception> T call(RegistrarCall<T, E> asked)
      throws RemoteException, E {
    busySince = Math.max(1, System.nanoTime());
    try {
      T answer = asked.ask();
      vouched = clock.instant();
      if (silent) {
        silent = false;
        incomplete = true; // it answers again: read everything
      }
      return answer;
    } finally {
      busySince = 0;
    }
  }

  private void cancel() {
    EventRegistration known = registration;
    if (known != null) {
      try {
        known.getLease().cancel();
      } catch (UnknownLeaseException | RemoteException | RuntimeException e) {
        LOG.debug("The events of {} end by themselves.", identity, e);
      }
    }
  }

  /** Closes the monitor without waiting for a running call. */
  @Override
  public void close() {
    worker.close(); // which cancels the registration for events
  }

  /** What the worker does. */
  private final class MonitorWork implements PooledWorker.Work {

    @Override
    public void step() throws IOException {
      RegistrarMonitor.this.step();
    }

    @Override
    public long nanosUntilNext() {
      return settings.heartbeatInterval().minus(age(beaten)).toNanos();
    }

    @Override
    public void end(@Nullable Exception failure) {
      RegistrarMonitor.this.end(failure);
    }
  }

  /** Queues the lookup service's events; never blocks it. */
  private final class ServiceEventListener implements RemoteEventListener {
    @Override
    public void notify(RemoteEvent event) {
      if (event instanceof ServiceEvent service) {
        if (!events.offer(service)) {
          incomplete = true;
        }
        worker.wake();
      }
    }
  }

  /** The lookup service, for people. */
  @Override
  public String toString() {
    return List.of(identity, silent ? "silent" : "answers").toString();
  }
}
