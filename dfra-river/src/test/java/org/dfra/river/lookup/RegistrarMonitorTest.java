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
            usual.reconcileInterval(),
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
        name -> {
          switch (name) {
            case "getServiceID":
              return id;
            case "notify":
              registered.countDown();
              return new EventRegistration(EVENTS, "the registrar", lease(), 0);
            case "lookup":
              return new ServiceMatches(new ServiceItem[0], 0);
            default:
              return null;
          }
        });
  }

  private Lease lease() {
    return fake(
        Lease.class,
        name -> {
          if (name.equals("renew")) {
            renewals.incrementAndGet();
          }
          return name.equals("getExpiration") ? Long.MAX_VALUE : null;
        });
  }

  private interface Answers {
    Object to(String method);
  }

  private static <T> T fake(Class<T> type, Answers answers) {
    return type.cast(
        Proxy.newProxyInstance(
            type.getClassLoader(),
            new Class<?>[] {type},
            (proxy, method, args) -> answers.to(method.getName())));
  }
}
