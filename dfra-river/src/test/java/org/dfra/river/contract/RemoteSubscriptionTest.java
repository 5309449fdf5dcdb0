package org.dfra.river.contract;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Proxy;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.UUID;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicReference;
import net.jini.export.Exporter;
import net.jini.jeri.BasicJeriExporter;
import org.dfra.core.time.StallProbe;
import org.dfra.core.time.Timing;
import org.dfra.event.Delivery;
import org.dfra.event.DeliveryPolicy;
import org.dfra.event.ModuleListener;
import org.dfra.event.Subscription;
import org.dfra.lease.LeaseRole;
import org.dfra.lease.LeaseStatus;
import org.dfra.lease.ModuleLease;
import org.dfra.lifecycle.Incident;
import org.dfra.lifecycle.Readiness;
import org.dfra.river.call.DeadlineExceededException;
import org.dfra.river.call.DeadlineILFactory;
import org.dfra.river.call.Endpoints;
import org.dfra.river.proxy.PendingLeaseCancellations;
import org.dfra.river.proxy.sensor.GPSProxy;
import org.dfra.river.remote.ModuleAdmin;
import org.dfra.river.remote.RemoteModuleListener;
import org.dfra.river.remote.sensor.RemoteGPSSensor;
import org.dfra.river.server.sensor.GPSServer;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/** What becomes of subscriptions and leases when the server or the client dies. */
@Timeout(180)
class RemoteSubscriptionTest {

  /** The requirement: subscriptions and leases are back so soon after their server. */
  private static final Duration BACK = Duration.ofSeconds(5);

  /** What is awaited; a bound that was missed is judged beside the probe's measurements. */
  private static final Duration PATIENCE = Duration.ofSeconds(30);

  private static final Duration LONGEST_LEASE = Duration.ofSeconds(4);

  /** The test polls ten times a second; the remaining time is for the timer. */
  private static final Duration NOTICED = Duration.ofMillis(300);

  @TempDir Path folder;

  private final AtomicReference<GPSServer> server = new AtomicReference<>();

  @AfterEach
  void end() {
    server.get().close();
  }

  @Test
  void comeBackByThemselvesWhenTheServerWasDeadAndCountTheGap() throws Exception {
    String state = folder.resolve("state").toString();
    server.set(Served.serve(UUID.randomUUID(), null, state));
    GPSProxy proxy = proxy();
    RecordingListener listener = new RecordingListener();
    try (StallProbe probe = StallProbe.start();
        Subscription subscription = proxy.subscribe(listener, DeliveryPolicy.latestReading());
        ModuleLease lease = proxy.acquireLease(Duration.ofSeconds(30))) {
      gps().solve(1);
      listener.await(1);

      server.get().close();
      await().atMost(PATIENCE).until(() -> subscription.interruptedSince().isPresent());
      server.set(Served.serve(UUID.randomUUID(), null, state));
      StallProbe.Stopwatch restarted = probe.stopwatch();
      gps().solve(2); // there is no listener yet: these two are lost
      gps().solve(3);
      await().atMost(PATIENCE).until(() -> gps().leases().clients() == 2);
      Timing back = restarted.stop();
      gps().solve(4);

      List<Delivery> received = listener.await(2);
      assertThat(listener.latitudes()).containsExactly(1.0, 4.0);
      assertThat(received.get(1).epoch()).isEqualTo(2);
      assertThat(received.get(1).sequence()).isEqualTo(received.get(0).sequence() + 3);
      assertThat(subscription.lost()).isEqualTo(2);
      await().atMost(PATIENCE).until(() -> subscription.interruptedSince().isEmpty());
      assertThat(lease.isLive()).isTrue();
      assertThat(proxy.readiness()).isEqualTo(Readiness.ACTIVE);
      assertThat(proxy.history().activations()).isEqualTo(2);
      assertThat(proxy.history().recent())
          .extracting(Incident::kind)
          .containsExactly(
              Incident.Kind.ACTIVATION, Incident.Kind.DEACTIVATION, Incident.Kind.ACTIVATION);
      back.requireWithin("subscription and lease coming back", BACK);
    }
    await().atMost(PATIENCE).until(() -> gps().leases().clients() == 0);
  }

  @Test
  void endAtTheServerWhenTheClientIsDead() throws Exception {
    Path configuration = folder.resolve("short.config");
    Files.writeString(
        configuration,
        "org.dfra.river.lease { longestLease = " + LONGEST_LEASE.toMillis() + "L; }");
    server.set(Served.serve(UUID.randomUUID(), configuration.toString(), null));
    RemoteModuleListener deaf = delivery -> {};
    Exporter exporter =
        new BasicJeriExporter(Endpoints.tcp("127.0.0.1", 0), new DeadlineILFactory(), false, false);
    ModuleListener stub = (ModuleListener) exporter.export(deaf);
    RemoteGPSSensor remote = (RemoteGPSSensor) server.get().getProxy();
    try (StallProbe probe = StallProbe.start()) {
      // The lease that a client's proxy would renew is not renewed.
      Subscription unused = remote.subscribe(stub, DeliveryPolicy.latestReading());
      ModuleLease unrenewed = remote.acquireLease(Duration.ofSeconds(3));
      StallProbe.Stopwatch granted = probe.stopwatch();
      assertThat(gps().leases().clients()).isEqualTo(2);
      assertThat(gps().events().entries()).hasSize(1);
      await().atMost(PATIENCE).until(() -> gps().leases().clients() == 0);
      Timing over = granted.stop();
      assertThat(gps().events().entries()).isEmpty();
      assertThat(gps().readiness()).isEqualTo(Readiness.READY);
      await()
          .atMost(PATIENCE)
          .until(() -> !unrenewed.isLive()); // the client counts from the answer
      assertThat(exporter.unexport(true)).isTrue();
      over.requireWithin(
          "the end of leases of 4 s that nobody renews", LONGEST_LEASE.plus(NOTICED));
    }
  }

  @Test
  void aRevokedHolderIsNotifiedAndDoesNotComeBack() throws Exception {
    server.set(Served.serve(UUID.randomUUID(), null, null));
    GPSProxy proxy = proxy();
    ModuleAdmin admin = (ModuleAdmin) proxy.getAdmin();
    RecordingListener listener = new RecordingListener();
    try (Subscription subscription = proxy.subscribe(listener, DeliveryPolicy.latestReading());
        ModuleLease lease = proxy.acquireLease(Duration.ofSeconds(30))) {
      gps().solve(1);
      listener.await(1);
      assertThat(admin.leases())
          .hasSize(2)
          .allSatisfy(
              each -> {
                assertThat(each.role()).isEqualTo(LeaseRole.CLIENT);
                assertThat(each.host()).isEqualTo("127.0.0.1");
                assertThat(each.remaining()).isBetween(Duration.ZERO, Duration.ofSeconds(30));
              });
      for (LeaseStatus each : admin.leases()) {
        assertThat(admin.revoke(each.handle())).isTrue();
        assertThat(admin.revoke(each.handle())).as("a second time").isFalse();
      }
      assertThat(gps().events().entries()).as("at once no events are sent any more").isEmpty();
      gps().solve(2);

      await().atMost(PATIENCE).until(() -> !subscription.isOpen() && !lease.isLive());
      assertThat(admin.leases()).as("nobody came back").isEmpty();
      assertThat(gps().readiness()).isEqualTo(Readiness.READY);
      assertThat(listener.latitudes()).containsExactly(1.0);
    }
  }

  @Test
  void aProgramCanWaitUntilItsLeasesAreGivenBack() throws Exception {
    server.set(Served.serve(UUID.randomUUID(), null, null));
    GPSProxy proxy = proxy();
    Subscription subscription =
        proxy.subscribe(new RecordingListener(), DeliveryPolicy.latestReading());
    ModuleLease lease = proxy.acquireLease(Duration.ofSeconds(30));
    assertThat(gps().leases().clients()).isEqualTo(2);
    subscription.close();
    lease.close();
    assertThat(PendingLeaseCancellations.await(PATIENCE)).isTrue();
    assertThat(gps().leases().clients()).isZero();
    assertThat(subscription.isOpen()).isFalse();
  }

  @Test
  void aListenerThatIsGoneIsDroppedAtItsFirstEvent() throws Exception {
    server.set(Served.serve(UUID.randomUUID(), null, null));
    RemoteModuleListener listener = delivery -> {};
    Exporter exporter =
        new BasicJeriExporter(Endpoints.tcp("127.0.0.1", 0), new DeadlineILFactory(), false, true);
    ModuleListener stub = (ModuleListener) exporter.export(listener);
    RemoteGPSSensor remote = (RemoteGPSSensor) server.get().getProxy();
    Subscription first = remote.subscribe(stub, DeliveryPolicy.latestReading());
    Subscription again = remote.subscribe(stub, DeliveryPolicy.latestReading());
    assertThat(gps().events().entries()).as("registered again, not twice").hasSize(1);
    assertThat(first).isNotEqualTo(again);
    assertThat(exporter.unexport(true)).isTrue();
    for (int i = 0;
        i < 3;
        i++) { // no such object is the end; no connection is one failure of three
      gps().solve(i);
    }
    await()
        .atMost(PATIENCE)
        .until(
            () -> {
              gps().solve(9);
              return gps().events().entries().isEmpty();
            });
    assertThat(gps().leases().clients()).isZero();
  }

  @Test
  void subscriptionsShareTheirThreads() throws Exception {
    server.set(Served.serve(UUID.randomUUID(), null, null));
    GPSProxy proxy = proxy();
    RecordingListener[] ears = new RecordingListener[50];
    Subscription[] subscriptions = new Subscription[ears.length];
    for (int i = 0; i < ears.length; i++) {
      ears[i] = new RecordingListener();
      subscriptions[i] = proxy.subscribe(ears[i], DeliveryPolicy.keepLast(10));
    }
    gps().solve(7);
    for (RecordingListener listener : ears) {
      listener.await(1);
    }
    assertThat(
            Thread.getAllStackTraces().keySet().stream()
                .filter(thread -> thread.getName().equals("dfra-timer")))
        .hasSize(1);
    for (Subscription subscription : subscriptions) {
      subscription.close();
    }
    await().atMost(PATIENCE).until(() -> gps().events().entries().isEmpty());
  }

  @Test
  void jrmpCarriesTheSameModuleByConfigurationAlone() throws Exception {
    Path configuration = folder.resolve("jrmp.config");
    Files.writeString(
        configuration,
        """
        import org.dfra.river.server.Exporters;
        import org.dfra.river.server.Exporters$ServerSettings;

        org.dfra.river.server {
            serverExporter = Exporters.jrmp((Exporters$ServerSettings) $data, 2000L);
        }
        """);
    server.set(Served.serve(UUID.randomUUID(), configuration.toString(), null));
    RemoteGPSSensor stub = (RemoteGPSSensor) server.get().getProxy();
    assertThat(Proxy.getInvocationHandler(stub)).asString().contains("UnicastRef");
    GPSProxy proxy = Served.proxy(stub, UUID.randomUUID(), server.get());
    RecordingListener listener = new RecordingListener();
    System.setProperty(
        "dfra.callback-host", "127.0.0.1"); // a JRMP stub does not reveal where its server is
    try (Subscription unused = proxy.subscribe(listener, DeliveryPolicy.latestReading())) {
      gps().solve(11);
      listener.await(1);
      assertThat(proxy.fix().position().latitude()).isEqualTo(11);
    } finally {
      System.clearProperty("dfra.callback-host");
    }
  }

  @Test
  void areMadeOnceThoughTheFirstAnswerWasLate() throws Exception {
    server.set(Served.serve(UUID.randomUUID(), null, null));
    AtomicInteger calls = new AtomicInteger();
    RemoteGPSSensor late =
        (RemoteGPSSensor)
            Proxy.newProxyInstance(
                getClass().getClassLoader(),
                new Class<?>[] {RemoteGPSSensor.class},
                (self, method, args) -> {
                  Object answer = method.invoke(server.get().getProxy(), args);
                  if (method.getName().equals("subscribe") && calls.incrementAndGet() == 1) {
                    throw new DeadlineExceededException("subscribe", Duration.ofSeconds(2), true);
                  }
                  return answer;
                });
    System.setProperty("dfra.callback-host", "127.0.0.1");
    GPSProxy proxy = Served.proxy(late, UUID.randomUUID(), server.get());
    RecordingListener listener = new RecordingListener();
    try (Subscription subscription = proxy.subscribe(listener, DeliveryPolicy.keepLast(10))) {
      assertThat(calls).hasValue(2);
      assertThat(gps().leases().clients()).as("listeners of the server").isEqualTo(1);
      gps().solve(1);
      gps().solve(2);
      listener.await(2);
      assertThat(listener.latitudes()).containsExactly(1.0, 2.0);
      assertThat(subscription.lost()).isZero();
    } finally {
      System.clearProperty("dfra.callback-host");
    }
    await().atMost(PATIENCE).until(() -> gps().leases().clients() == 0);
  }

  private static ScriptedGps gps() {
    return ScriptedGps.last(ModuleContract.PATH);
  }

  /** A proxy whose stub finds the server that is there now, as a resurrecting one does. */
  private GPSProxy proxy() throws Exception {
    RemoteGPSSensor stub =
        (RemoteGPSSensor)
            Proxy.newProxyInstance(
                getClass().getClassLoader(),
                new Class<?>[] {RemoteGPSSensor.class},
                (self, method, args) -> {
                  try {
                    return method.invoke(server.get().getProxy(), args);
                  } catch (InvocationTargetException e) {
                    throw e.getCause();
                  }
                });
    System.setProperty("dfra.callback-host", "127.0.0.1");
    return Served.proxy(stub, UUID.randomUUID(), server.get());
  }
}
