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
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import net.jini.core.discovery.LookupLocator;
import net.jini.core.entry.Entry;
import net.jini.core.event.EventRegistration;
import net.jini.core.event.RemoteEvent;
import net.jini.core.event.RemoteEventListener;
import net.jini.core.lease.LeaseDeniedException;
import net.jini.core.lease.UnknownLeaseException;
import net.jini.core.lookup.ServiceEvent;
import net.jini.core.lookup.ServiceID;
import net.jini.core.lookup.ServiceItem;
import net.jini.core.lookup.ServiceMatches;
import net.jini.core.lookup.ServiceRegistrar;
import net.jini.core.lookup.ServiceTemplate;
import net.jini.export.Exporter;
import org.dfra.river.discovery.LocatedRegistrar;
import org.dfra.river.entry.ModuleEntry;
import org.dfra.river.loading.LoadingFaults;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Follows what one lookup service holds: by its events, by a sign of life at every heartbeat, and
 * by asking for everything now and then, in case an event was lost.
 *
 * <p>Threads: one daemon, {@code dfra-registrar-id}, makes every call to the lookup service. Where
 * such a call hangs, only this thread does; {@link #check}, on the directory's own thread, notices.
 */
final class RegistrarMonitor implements AutoCloseable {

  private static final Logger LOG = LoggerFactory.getLogger(RegistrarMonitor.class);

  private static final int TRANSITIONS =
      ServiceRegistrar.TRANSITION_MATCH_MATCH
          | ServiceRegistrar.TRANSITION_MATCH_NOMATCH
          | ServiceRegistrar.TRANSITION_NOMATCH_MATCH;

  /** So many events may wait; past them everything is asked for instead. */
  private static final int LONGEST_QUEUE = 10_000;

  private final LocatedRegistrar identity;
  private final ServiceRegistrar registrar; // the same, for calls
  private final ServiceTable sightings;
  private final DirectorySettings settings;
  private final InstantSource clock;
  private final Exporter exporter;
  private final Runnable reader;
  private final Consumer<RegistrarMonitor> end;
  private final BlockingQueue<ServiceEvent> events = new LinkedBlockingQueue<>(LONGEST_QUEUE);
  private final Thread thread;

  /** Kept here, since JERI does not keep what it exported. */
  private final ServiceEventListener listener = new ServiceEventListener();

  private volatile boolean closed;
  private volatile boolean read; // everything, once at least
  private volatile boolean incomplete = true; // something was missed
  private volatile Instant vouched;
  private volatile long busySince; // System.nanoTime of a call under way; 0 for none
  private volatile boolean silent;
  private final Map<ServiceID, String> faults = new HashMap<>(); // of proxies; by the thread
  private @Nullable EventRegistration registration; // by the thread
  private long sequence; // by the thread
  private long complete; // System.nanoTime when all was asked for; by the thread
  private boolean located; // whether its computer was asked for; by the thread
  private long beaten = System.nanoTime(); // when the last heartbeat was sent; by the thread

  /**
   * @param exporter exports the listener while the watch goes on
   * @param reader is told when everything was read, on the watch's thread
   * @param end is told when the lookup service has failed and the watch is over
   */
  RegistrarMonitor(
      LocatedRegistrar identity,
      ServiceTable sightings,
      DirectorySettings settings,
      InstantSource clock,
      Exporter exporter,
      Runnable reader,
      Consumer<RegistrarMonitor> end) {
    this.identity = identity;
    this.registrar = identity;
    this.sightings = sightings;
    this.settings = settings;
    this.clock = clock;
    this.exporter = exporter;
    this.reader = reader;
    this.end = end;
    this.vouched = clock.instant();
    this.thread = new Thread(this::run, "dfra-registrar-" + identity.getServiceID());
    thread.setDaemon(true);
    thread.setContextClassLoader(Thread.currentThread().getContextClassLoader());
  }

  void start() {
    thread.start();
  }

  LocatedRegistrar registrar() {
    return identity;
  }

  /** Whether everything that it holds was read once. */
  boolean isRead() {
    return read;
  }

  /** Notices a lookup service that does not answer. */
  void check(long nanos) {
    long since = busySince;
    if (since != 0 && nanos - since > settings.registrarTimeout().toNanos() && !silent) {
      silent = true;
      LOG.warn("Lookup service {} does not answer; what it holds is stale.", identity);
      sightings.markOutOfReach(identity, vouched);
    }
  }

  private void run() {
    try {
      RemoteEventListener stub = (RemoteEventListener) exporter.export(listener);
      while (!closed) {
        if (registration == null) {
          register(stub);
        }
        if (incomplete || age(complete).compareTo(settings.reconcileInterval()) > 0) {
          reconcile();
        }
        @Nullable ServiceEvent event =
            events.poll(
                settings.heartbeatInterval().minus(age(beaten)).toNanos(), TimeUnit.NANOSECONDS);
        if (event != null) {
          take(event);
        }
        // By time: where events come faster than it beats, the lease on them must live all the
        // same.
        if (age(beaten).compareTo(settings.heartbeatInterval()) >= 0) {
          beaten = System.nanoTime();
          beat();
        }
      }
      cancel();
    } catch (InterruptedException e) {
      cancel();
    } catch (IOException | RuntimeException e) {
      if (!closed) {
        LOG.info("Lookup service {} is out of reach: {}", identity, e.toString());
      }
    } finally {
      exporter.unexport(true);
      busySince = 0;
      if (!closed) {
        sightings.markOutOfReach(identity, vouched);
        end.accept(this);
      }
    }
  }

  private static Duration age(long since) {
    return Duration.ofNanos(System.nanoTime() - since);
  }

  private void register(RemoteEventListener stub) throws RemoteException {
    events.clear();
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
    incomplete = true;
  }

  /**
   * Asks for everything, robot by robot: so no answer is so large that it misses its deadline. What
   * changes meanwhile comes as an event afterwards.
   */
  private void reconcile() throws RemoteException {
    incomplete = false;
    Map<ServiceID, ServiceItem> items = new HashMap<>();
    ServiceTemplate modules = new ServiceTemplate(null, null, new Entry[] {new ModuleEntry()});
    @Nullable Object[] robots =
        call(
            () -> {
              try {
                return registrar.getFieldValues(modules, 0, "robot");
              } catch (NoSuchFieldException e) {
                throw new AssertionError(e);
              }
            });
    for (@Nullable Object robot : robots == null ? new Object[0] : robots) {
      ModuleEntry of = new ModuleEntry();
      of.robot = (String) robot;
      lookup(new ServiceTemplate(null, null, new Entry[] {of}), items);
    }
    lookup(new ServiceTemplate(null, new Class<?>[] {ServiceRegistrar.class}, null), items);
    silent = false;
    locate();
    faults.keySet().retainAll(items.keySet());
    // What can be used does not wait for what cannot.
    sightings.replaceAll(identity, items.values(), faults);
    findFaults(items.values());
    complete = System.nanoTime();
    read = true;
    reader.run();
  }

  /** Asks once which computer it runs on. */
  private void locate() throws RemoteException {
    if (!located) {
      @Nullable LookupLocator locator = call(() -> registrar.getLocator());
      if (locator != null) {
        sightings.setHost(identity, locator.getHost());
      }
      located = true;
    }
  }

  /** Finds why proxies could not be read, where that is not known yet. */
  private void findFaults(Collection<ServiceItem> items) throws RemoteException {
    for (ServiceItem item : items) {
      if (item.service != null) {
        faults.remove(item.serviceID);
      } else if (!faults.containsKey(item.serviceID)) {
        Optional<String> fault = fault(item.serviceID);
        if (fault.isPresent()) {
          faults.put(item.serviceID, fault.get());
          sightings.update(identity, item, fault.get());
        }
      }
    }
  }

  private void lookup(ServiceTemplate template, Map<ServiceID, ServiceItem> items)
      throws RemoteException {
    ServiceMatches matches = call(() -> registrar.lookup(template, Integer.MAX_VALUE));
    for (ServiceItem item : matches.items) {
      items.put(item.serviceID, item);
    }
  }

  /** Why the proxy of one cannot be read; it is read again for that, by itself. */
  private Optional<String> fault(ServiceID service) throws RemoteException {
    ServiceTemplate one = new ServiceTemplate(service, null, null);
    return LoadingFaults.during(
        () -> {
          ServiceMatches unused = call(() -> registrar.lookup(one, 1));
        });
  }

  private void take(ServiceEvent event) throws RemoteException {
    EventRegistration known = registration;
    if (known == null || event.getID() != known.getID()) {
      return; // of a registration before this one
    }
    long next = event.getSequenceNumber();
    if (next != sequence + 1) {
      incomplete = true;
    }
    sequence = Math.max(sequence, next);
    if (event.getTransition() == ServiceRegistrar.TRANSITION_MATCH_NOMATCH) {
      sightings.remove(identity, ServiceTable.uuid(event.getServiceID()));
      return;
    }
    @Nullable ServiceItem item = event.getServiceItem();
    if (item == null) {
      return;
    }
    Optional<String> fault = item.service == null ? fault(item.serviceID) : Optional.empty();
    if (fault.isPresent()) {
      faults.put(item.serviceID, fault.get());
      sightings.update(identity, item, fault.get());
    } else {
      faults.remove(item.serviceID);
      sightings.update(identity, item);
    }
  }

  /** A sign of life that also keeps the events coming. */
  private void beat() throws RemoteException {
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
      registration = null; // it came back without its memory
    }
  }

  private interface RegistrarCall<T, E extends Exception> {
    T ask() throws RemoteException, E;
  }

  private <T, E extends Exception> T call(RegistrarCall<T, E> asked) throws RemoteException, E {
    busySince = Math.max(1, System.nanoTime());
    try {
      T answer = asked.ask();
      vouched = clock.instant();
      if (silent) {
        incomplete = true; // it is back: everything is asked for anew
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

  /** Ends it, without waiting for a call that is under way. */
  @Override
  public void close() {
    closed = true;
    thread.interrupt();
  }

  /** Takes events from the lookup service; never blocks it. */
  private final class ServiceEventListener implements RemoteEventListener {
    @Override
    public void notify(RemoteEvent event) {
      if (event instanceof ServiceEvent service && !events.offer(service)) {
        incomplete = true;
      }
    }
  }

  /** What it follows, for people. */
  @Override
  public String toString() {
    return List.of(identity, silent ? "silent" : "answers").toString();
  }
}
