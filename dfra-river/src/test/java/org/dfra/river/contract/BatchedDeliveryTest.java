package org.dfra.river.contract;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Proxy;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.UUID;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.DoubleStream;
import java.util.stream.LongStream;
import net.jini.export.Exporter;
import org.dfra.event.Delivery;
import org.dfra.event.DeliveryPolicy;
import org.dfra.event.Subscription;
import org.dfra.lease.LeaseStatus;
import org.dfra.river.call.DeadlineILFactory;
import org.dfra.river.call.Endpoints;
import org.dfra.river.call.JeriExporters;
import org.dfra.river.proxy.sensor.GPSProxy;
import org.dfra.river.remote.RemoteModuleListener;
import org.dfra.river.remote.sensor.RemoteGPSSensor;
import org.dfra.river.server.sensor.GPSServer;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/** What a module's calls to a listener in another process deliver, and which lease they renew. */
@Timeout(120)
class BatchedDeliveryTest {

  private static final Duration PATIENCE = Duration.ofSeconds(30);

  @TempDir Path folder;

  private final List<GPSServer> servers = new ArrayList<>();
  private final List<Exporter> exporters = new ArrayList<>();

  @AfterEach
  void end() {
    exporters.forEach(each -> each.unexport(true));
    servers.forEach(GPSServer::close);
  }

  private GPSServer serve(String configuration) throws Exception {
    Path file = folder.resolve("module.config");
    Files.writeString(file, configuration);
    GPSServer server = Served.serve(UUID.randomUUID(), file.toString(), null);
    servers.add(server);
    return server;
  }

  private static ScriptedGps gps() {
    return ScriptedGps.last(ModuleContract.PATH);
  }

  /** Records the calls, and holds the first of them until the test lets it go. */
  private static final class HeldListener implements RemoteModuleListener {
    final List<Integer> calls = new CopyOnWriteArrayList<>();
    final List<Long> received = new CopyOnWriteArrayList<>();
    final CountDownLatch released = new CountDownLatch(1);
    final CountDownLatch held = new CountDownLatch(1);

    @Override
    public void notify(Delivery delivery) {
      received.add(delivery.sequence());
    }

    @Override
    public void notify(Delivery delivery, long call, long renewed) {
      calls.add(1);
      notify(delivery);
      held.countDown();
      try {
        released.await();
      } catch (InterruptedException e) {
        Thread.currentThread().interrupt();
      }
    }

    @Override
    public void notify(List<Delivery> deliveries, long call, long renewed) {
      calls.add(deliveries.size());
      deliveries.forEach(this::notify);
    }
  }

  private RemoteModuleListener export(RemoteModuleListener listener) throws Exception {
    Exporter exporter =
        JeriExporters.notKeepingAlive(Endpoints.tcp("127.0.0.1", 0), new DeadlineILFactory());
    exporters.add(exporter);
    return (RemoteModuleListener) exporter.export(listener);
  }

  @Test
  void whatWaitsWhileACallIsUnderWayComesInTheNext() throws Exception {
    RemoteGPSSensor remote = (RemoteGPSSensor) serve("").getProxy();
    HeldListener listener = new HeldListener();
    try (Subscription unused =
        remote.subscribe(
            export(listener),
            DeliveryPolicy.keepLast(100).withKinds(DeliveryPolicy.EventKind.READING))) {
      gps().solve(1);
      assertThat(listener.held.await(20, java.util.concurrent.TimeUnit.SECONDS)).isTrue();
      for (int i = 2; i <= 80; i++) {
        gps().solve(i);
      }
      listener.released.countDown();
      await().atMost(PATIENCE).until(() -> listener.received.size() == 80);
      assertThat(listener.calls).containsExactly(1, 64, 15);
      assertThat(listener.received).isEqualTo(LongStream.rangeClosed(1, 80).boxed().toList());
    }
  }

  /** The listener at the end of a subscription still gets one event at a time, and all of them. */
  @Test
  void aListenerThatThrowsGetsTheOtherEventsOfTheSameCall() throws Exception {
    GPSProxy proxy = proxy(serve(""), new AtomicInteger());
    RecordingListener listener = new RecordingListener();
    listener.throwing = true;
    try (Subscription subscription = proxy.subscribe(listener, DeliveryPolicy.keepLast(100))) {
      for (int i = 1; i <= 50; i++) {
        gps().solve(i);
      }
      listener.await(50);
      assertThat(listener.latitudes())
          .containsSubsequence(DoubleStream.iterate(1, i -> i + 1).limit(50).boxed().toList());
      assertThat(subscription.lost()).isZero();
    }
  }

  /** The lease lasts 3 s; nobody renews it but the module's own calls. */
  @Test
  void eventsThatAreAcceptedKeepTheLeaseAndOthersDoNot() throws Exception {
    String threeSeconds = "org.dfra.river.lease { longestLease = 9000L; defaultLease = 3000L; }";
    RemoteGPSSensor remote = (RemoteGPSSensor) serve(threeSeconds).getProxy();
    AtomicInteger accepted = new AtomicInteger();
    RemoteModuleListener kept = delivery -> accepted.incrementAndGet();
    RemoteModuleListener silent =
        delivery -> {
          throw new IllegalStateException("refuses every event");
        };
    Subscription unused = remote.subscribe(export(kept), DeliveryPolicy.latestReading());
    Subscription alsoUnused =
        remote.subscribe(
            export(silent),
            DeliveryPolicy.keepLast(1).withKinds(DeliveryPolicy.EventKind.PARAMETER));
    assertThat(gps().leases().leases()).hasSize(2);
    long begin = System.nanoTime();
    await()
        .atMost(PATIENCE)
        .pollInterval(Duration.ofMillis(200))
        .until(
            () -> {
              gps().solve(1);
              return gps().leases().leases().size() == 1
                  && System.nanoTime() - begin > Duration.ofSeconds(7).toNanos();
            });
    assertThat(gps().events().entries()).as("the one that accepts events").hasSize(1);
    LeaseStatus lease = gps().leases().leases().get(0);
    assertThat(lease.age()).isGreaterThan(Duration.ofSeconds(7));
    assertThat(accepted.get()).isGreaterThan(10);
    await().atMost(PATIENCE).until(() -> gps().leases().leases().isEmpty());
  }

  /** A lease that ended would be noticed, and its listener registered a second time. */
  @Test
  void aSubscriptionToABusyModuleStaysOpen() throws Exception {
    AtomicInteger subscribed = new AtomicInteger();
    GPSProxy proxy =
        proxy(
            serve("org.dfra.river.lease { longestLease = 9000L; defaultLease = 3000L; }"),
            subscribed);
    RecordingListener listener = new RecordingListener();
    try (Subscription subscription = proxy.subscribe(listener, DeliveryPolicy.latestReading())) {
      long begin = System.nanoTime();
      await()
          .atMost(PATIENCE)
          .pollInterval(Duration.ofMillis(100))
          .until(
              () -> {
                gps().solve(1);
                return System.nanoTime() - begin > Duration.ofSeconds(7).toNanos();
              });
      assertThat(subscription.isOpen()).isTrue();
      assertThat(subscription.interruptedSince()).isEmpty();
      assertThat(subscribed).as("registrations").hasValue(1);
      assertThat(gps().leases().clients()).isEqualTo(1);
    }
  }

  private static GPSProxy proxy(GPSServer server, AtomicInteger subscribed) throws Exception {
    RemoteGPSSensor stub =
        (RemoteGPSSensor)
            Proxy.newProxyInstance(
                BatchedDeliveryTest.class.getClassLoader(),
                new Class<?>[] {RemoteGPSSensor.class},
                (self, method, args) -> {
                  if (method.getName().equals("subscribe")) {
                    subscribed.incrementAndGet();
                  }
                  try {
                    return method.invoke(server.getProxy(), args);
                  } catch (InvocationTargetException e) {
                    throw e.getCause();
                  }
                });
    System.setProperty("dfra.callback-host", "127.0.0.1");
    return Served.proxy(stub, UUID.randomUUID(), server);
  }
}
