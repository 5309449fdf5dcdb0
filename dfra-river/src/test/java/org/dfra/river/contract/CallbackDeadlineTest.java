package org.dfra.river.contract;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.UUID;
import java.util.concurrent.CountDownLatch;
import net.jini.export.Exporter;
import net.jini.jeri.BasicILFactory;
import net.jini.jeri.BasicJeriExporter;
import net.jini.jeri.tcp.TcpServerEndpoint;
import org.dfra.core.host.FreePorts;
import org.dfra.core.time.StallProbe;
import org.dfra.core.time.Timing;
import org.dfra.event.Delivery;
import org.dfra.event.DeliveryPolicy;
import org.dfra.event.ModuleListener;
import org.dfra.event.Subscription;
import org.dfra.river.call.Endpoints;
import org.dfra.river.proxy.sensor.GPSProxy;
import org.dfra.river.remote.RemoteModule;
import org.dfra.river.remote.RemoteModuleListener;
import org.dfra.river.server.sensor.GPSServer;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/** Listeners of stock JERI peers are served, and those that do not answer delay no others. */
@Timeout(120)
class CallbackDeadlineTest {

  private static final String HOST = "127.0.0.1";
  private static final Duration PATIENCE = Duration.ofSeconds(30);

  /** The requirement: how long an honest listener waits for an event beside silent ones. */
  private static final Duration DELIVERED = Duration.ofSeconds(1);

  private static final int SILENT = 30;

  /** The pool's few, the silent process' share of it, the honest one's, and one that ends. */
  private static final int THREADS = 4 + 4 + 4 + 1;

  @TempDir Path folder;

  private final CountDownLatch release = new CountDownLatch(1);
  private int stockPort;
  private final List<RemoteModuleListener> listeners = new ArrayList<>(); // JERI holds them weakly
  private final List<Exporter> exporters = new ArrayList<>();

  @AfterEach
  void end() {
    release.countDown();
    for (Exporter each : exporters) {
      boolean unused = each.unexport(true);
    }
  }

  /** As stock peers export, in a process of their own as far as the port tells: no deadline. */
  private ModuleListener stock(RemoteModuleListener listener) throws Exception {
    Exporter exporter =
        new BasicJeriExporter(
            TcpServerEndpoint.getInstance(
                HOST, stockPort, null, Endpoints.serverSocketFactory(HOST)),
            new BasicILFactory(),
            false,
            false);
    listeners.add(listener);
    exporters.add(exporter);
    return (ModuleListener) exporter.export(listener);
  }

  private void neverAnswer(Delivery delivery) {
    try {
      release.await();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  private static ScriptedGps gps() {
    return ScriptedGps.last(ModuleContract.PATH);
  }

  private GPSServer serve(String lease) throws Exception {
    Path configuration =
        Files.writeString(
            folder.resolve("leases.config"), "org.dfra.river.lease { " + lease + " }");
    return Served.serve(UUID.randomUUID(), configuration.toString(), null);
  }

  @BeforeEach
  void choosePort() throws IOException {
    stockPort = FreePorts.allocate();
  }

  @Test
  void aStockListenerIsServed() throws Exception {
    try (GPSServer server = serve("longestLease = 30000L;")) {
      RecordingListener listener = new RecordingListener();
      Subscription subscribed =
          ((RemoteModule) server.getProxy())
              .subscribe(stock(listener::notify), DeliveryPolicy.keepLast(10));
      assertThat(subscribed.isOpen()).isTrue();
      gps().solve(1);
      gps().solve(2);
      await().atMost(PATIENCE).until(() -> listener.latitudes().equals(List.of(1.0, 2.0)));
    }
  }

  @Test
  void listenersThatNeverAnswerHoldUpNoHonestOneAndEndWithTheirLeases() throws Exception {
    try (StallProbe probe = StallProbe.start();
        GPSServer server = serve("longestLease = 12000L; defaultLease = 6000L;")) {
      RemoteModule remote = (RemoteModule) server.getProxy();
      for (int i = 0; i < SILENT; i++) {
        Subscription unrenewed =
            remote.subscribe(stock(this::neverAnswer), DeliveryPolicy.latestReading());
        assertThat(unrenewed).isNotNull();
      }
      assertThat(gps().events().entries()).hasSize(SILENT);

      // Under another identity the proxy does not find the module in this virtual machine.
      GPSProxy proxy = Served.proxy(remote, UUID.randomUUID(), server);
      RecordingListener listener = new RecordingListener();
      try (Subscription honest = proxy.subscribe(listener, DeliveryPolicy.keepLast(10))) {
        List<Timing> delivered = new ArrayList<>();
        for (int i = 1; i <= 5; i++) {
          StallProbe.Stopwatch published = probe.stopwatch();
          gps().solve(i);
          assertThat(listener.await(i)).hasSize(i);
          delivered.add(published.stop());
        }
        assertThat(threads("dfra-events-"))
            .as("threads of deliveries beside %d silent listeners", SILENT)
            .isLessThanOrEqualTo(THREADS);
        await("the silent ones end with their leases")
            .atMost(PATIENCE)
            .until(() -> gps().events().entries().size() == 1);
        assertThat(honest.isOpen()).isTrue();
        assertThat(honest.lost()).isZero();
        for (Timing each : delivered) {
          each.requireWithin("an event beside silent listeners", DELIVERED);
        }
      }
    }
  }

  private static long threads(String prefix) {
    return Thread.getAllStackTraces().keySet().stream()
        .filter(thread -> thread.getName().startsWith(prefix))
        .count();
  }
}
