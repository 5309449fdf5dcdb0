package org.dfra.river.contract;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.UUID;
import net.jini.export.Exporter;
import net.jini.jeri.BasicJeriExporter;
import org.dfra.event.DeliveryPolicy;
import org.dfra.event.ModuleListener;
import org.dfra.event.Subscription;
import org.dfra.river.call.DeadlineILFactory;
import org.dfra.river.call.Endpoints;
import org.dfra.river.proxy.sensor.GPSProxy;
import org.dfra.river.remote.RemoteModule;
import org.dfra.river.remote.RemoteModuleListener;
import org.dfra.river.server.sensor.GPSServer;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/** A subscription that is closed leaves nothing behind at the server. */
@Timeout(120)
class ClosedSubscriptionTest {

  private static final int MANY = 300;
  private static final Duration PATIENCE = Duration.ofSeconds(30);

  @TempDir Path folder;

  private static ScriptedGps gps() {
    return ScriptedGps.last(ModuleContract.PATH);
  }

  @Test
  void manySubscriptionsThatAreClosedLeaveNoneAtTheServer() throws Exception {
    UUID id = UUID.randomUUID();
    try (GPSServer server = Served.serve(id, null, null)) {
      // Under another identity the proxy does not find the module in this virtual machine.
      GPSProxy proxy = Served.proxy((RemoteModule) server.getProxy(), UUID.randomUUID(), server);
      for (int i = 0; i < MANY; i++) {
        proxy.subscribe(event -> {}, DeliveryPolicy.latestReading()).close();
      }
      await()
          .atMost(PATIENCE)
          .untilAsserted(() -> assertThat(gps().events().entries().size()).isZero());
      assertThat(gps().leases().leases()).isEmpty();
    }
  }

  @Test
  void oneWhoseCloseDoesNotReachTheServerEndsWithItsLease() throws Exception {
    Path configuration =
        Files.writeString(
            folder.resolve("short.config"), "org.dfra.river.lease { longestLease = 1000L; }");
    try (GPSServer server = Served.serve(UUID.randomUUID(), configuration.toString(), null)) {
      RemoteModuleListener deaf = event -> {};
      Exporter exporter =
          new BasicJeriExporter(
              Endpoints.tcp("127.0.0.1", 0), new DeadlineILFactory(), false, false);
      ModuleListener stub = (ModuleListener) exporter.export(deaf);
      Subscription unclosed =
          ((RemoteModule) server.getProxy()).subscribe(stub, DeliveryPolicy.latestReading());
      assertThat(gps().events().entries()).hasSize(1);
      await()
          .atMost(PATIENCE)
          .untilAsserted(() -> assertThat(gps().events().entries().size()).isZero());
      // Each side counts the lease from when it was granted as it knows; they differ by the call.
      await().atMost(PATIENCE).until(() -> !unclosed.isOpen());
      assertThat(exporter.unexport(true)).isTrue();
    }
  }
}
