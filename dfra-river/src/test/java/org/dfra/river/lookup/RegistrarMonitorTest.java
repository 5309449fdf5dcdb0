package org.dfra.river.lookup;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import java.io.IOException;
import java.lang.reflect.Proxy;
import java.net.InetSocketAddress;
import java.rmi.Remote;
import java.rmi.RemoteException;
import java.time.Duration;
import java.time.InstantSource;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicReference;
import java.util.concurrent.locks.LockSupport;
import net.jini.core.event.EventRegistration;
import net.jini.core.event.RemoteEventListener;
import net.jini.core.event.UnknownEventException;
import net.jini.core.lease.Lease;
import net.jini.core.lookup.ServiceEvent;
import net.jini.core.lookup.ServiceID;
import net.jini.core.lookup.ServiceItem;
import net.jini.core.lookup.ServiceMatches;
import net.jini.core.lookup.ServiceRegistrar;
import net.jini.export.Exporter;
import net.jini.io.MarshalledInstance;
import org.dfra.core.directory.CachedModuleDirectory;
import org.dfra.core.directory.ModuleTable;
import org.dfra.directory.Locality;
import org.dfra.river.discovery.LocatedRegistrar;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** A lookup service gets its heartbeats, whatever else happens. */
@Timeout(60)
class RegistrarMonitorTest {

  private static final long EVENTS = 7;
  private static final Duration HEARTBEAT = Duration.ofMillis(100);

  private final ServiceID id = new ServiceID(1, 2);
  private final AtomicInteger renewals = new AtomicInteger();
  private final AtomicReference<RemoteEventListener> listener = new AtomicReference<>();
  private final CountDownLatch registered = new CountDownLatch(1);
  private final AtomicInteger complete = new AtomicInteger(); // queries that return services
  private final AtomicInteger comparisons = new AtomicInteger(); // queries that return none
  private final AtomicInteger services = new AtomicInteger();

  @Test
  void theLeaseOnEventsIsRenewedWhereEventsComeFasterThanHeartbeats() throws Exception {
    try (RegistrarMonitor watch = watch()) {
      watch.start();
      assertThat(registered.await(30, TimeUnit.SECONDS)).isTrue();
      AtomicInteger sequence = new AtomicInteger();
      AtomicReference<Exception> failure = new AtomicReference<>();
      Thread flood = new Thread(() -> flood(sequence, failure), "events");
      flood.start();
      try {
        await("heartbeats").atMost(Duration.ofSeconds(20)).until(() -> renewals.get() >= 3);
        assertThat(sequence.get()).as("events meanwhile").isGreaterThan(3);
      } finally {
        flood.interrupt();
        flood.join();
      }
      assertThat(failure.get()).as("what ended the events").isNull();
    }
  }

  @Test
  void readsEverythingOnceIfNothingIsLost() throws Exception {
    try (RegistrarMonitor watch = watch()) {
      watch.start();
      await("comparisons").atMost(Duration.ofSeconds(20)).until(() -> comparisons.get() >= 3);
      int first = complete.get();
      services.incrementAndGet();
      listener.get().notify(new Added(1));
      int compared = comparisons.get();
      await("comparisons").until(() -> comparisons.get() >= compared + 5);
      assertThat(complete).as("complete queries").hasValue(first);
    }
  }

  @Test
  void readsEverythingAgainIfAnEventWasLost() throws Exception {
    try (RegistrarMonitor watch = watch()) {
      watch.start();
      await("comparisons").atMost(Duration.ofSeconds(20)).until(() -> comparisons.get() >= 2);
      int first = complete.get();
      services.incrementAndGet(); // and no event says so
      await("a complete query")
          .atMost(Duration.ofSeconds(20))
          .until(() -> complete.get() > first && comparisons.get() > 3);
      int second = complete.get();
      int compared = comparisons.get();
      await("comparisons").until(() -> comparisons.get() >= compared + 4);
      assertThat(complete).as("complete queries, when that is known").hasValue(second);
      listener.get().notify(new Gone(5)); // the four before are missing
      await("a complete query").until(() -> complete.get() > second);
    }
  }

  @Test
  void aClosedOneEndsItsRegistrationForEvents() throws Exception {
    RegistrarMonitor watch = watch();
    watch.start();
    await("heartbeats").atMost(Duration.ofSeconds(20)).until(() -> renewals.get() >= 2);
    watch.close();
    assertThat(cancelled.await(20, TimeUnit.SECONDS)).as("cancelled").isTrue();
    assertThat(unexported.await(20, TimeUnit.SECONDS)).as("the listener is unexported").isTrue();
    int last = renewals.get();
    assertThat(new CountDownLatch(1).await(5 * HEARTBEAT.toMillis(), TimeUnit.MILLISECONDS))
        .isFalse();
    assertThat(renewals).as("heartbeats afterwards").hasValue(last);
  }

  /** Keeps events waiting all the time, so that the watch never finds its queue empty. */
  private void flood(AtomicInteger sequence, AtomicReference<Exception> failure) {
    while (!Thread.currentThread().isInterrupted()) {
      try {
        for (int i = 0; i < 200; i++) {
          listener.get().notify(new Gone(sequence.incrementAndGet()));
        }
        LockSupport.parkNanos(1_000_000); // or they would be more than its queue takes
      } catch (UnknownEventException | RemoteException | RuntimeException e) {
        failure.set(e);
        return;
      }
    }
  }

  private final CountDownLatch cancelled = new CountDownLatch(1);
  private final CountDownLatch unexported = new CountDownLatch(1);

  private final class Added extends ServiceEvent {
    private static final long serialVersionUID = 1L;

    Added(long number) {
      super(
          "the registrar",
          EVENTS,
          number,
          null,
          new ServiceID(3, 4),
          ServiceRegistrar.TRANSITION_NOMATCH_MATCH);
    }

    @Override
    public ServiceItem getServiceItem() {
      return null;
    }
  }

  private final class Gone extends ServiceEvent {
    private static final long serialVersionUID = 1L;

    Gone(long number) {
      super(
          "the registrar",
          EVENTS,
          number,
          null,
          new ServiceID(3, 4),
          ServiceRegistrar.TRANSITION_MATCH_NOMATCH);
    }

    @Override
    public ServiceItem getServiceItem() {
      return null;
    }
  }

  private RegistrarMonitor watch() throws IOException {
    DirectorySettings usual = DirectorySettings.of("127.0.0.1", List.of(), List.of());
    DirectorySettings settings =
        new DirectorySettings(
            usual.callbackHost(),
            usual.groups(),
            usual.locators(),
            usual.locatorRetry(),
            HEARTBEAT,
            usual.registrarTimeout(),
            HEARTBEAT.dividedBy(2), // compares at each heartbeat
            usual.eventLease());
    Exporter exporter =
        new Exporter() {
          @Override
          public Remote export(Remote object) {
            listener.set((RemoteEventListener) object);
            return object;
          }

          @Override
          public boolean unexport(boolean force) {
            unexported.countDown();
            return true;
          }
        };
    return new RegistrarMonitor(
        new LocatedRegistrar(
            registrar(), new MarshalledInstance("a proxy"), new InetSocketAddress("127.0.0.1", 1)),
        new ServiceTable(new Nothing().known(), (module, attributes) -> Locality.REMOTE),
        settings,
        InstantSource.system(),
        exporter,
        () -> {},
        ended -> {});
  }

  /** A directory that nobody fills. */
  private static final class Nothing extends CachedModuleDirectory {

    Nothing() {
      super(InstantSource.system());
    }

    ModuleTable known() {
      return table();
    }
  }

  private ServiceRegistrar registrar() {
    return fake(
        ServiceRegistrar.class,
        (name, args) -> {
          switch (name) {
            case "getServiceID":
              return id;
            case "notify":
              registered.countDown();
              return new EventRegistration(EVENTS, "the registrar", lease(), 0);
            case "lookup":
              boolean isComparison = Integer.valueOf(0).equals(args[1]);
              (isComparison ? comparisons : complete).incrementAndGet();
              return new ServiceMatches(new ServiceItem[0], services.get());
            default:
              return null;
          }
        });
  }

  private Lease lease() {
    return fake(
        Lease.class,
        (name, args) -> {
          if (name.equals("renew")) {
            renewals.incrementAndGet();
          } else if (name.equals("cancel")) {
            cancelled.countDown();
          }
          return name.equals("getExpiration") ? Long.MAX_VALUE : null;
        });
  }

  private interface Answers {
    Object to(String method, Object[] args);
  }

  private static <T> T fake(Class<T> type, Answers answers) {
    return type.cast(
        Proxy.newProxyInstance(
            type.getClassLoader(),
            new Class<?>[] {type},
            (proxy, method, args) -> answers.to(method.getName(), args)));
  }
}
