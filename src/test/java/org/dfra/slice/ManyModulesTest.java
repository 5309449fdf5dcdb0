package org.dfra.slice;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import java.lang.management.ManagementFactory;
import java.rmi.RemoteException;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.UUID;
import net.jini.core.lookup.ServiceTemplate;
import org.dfra.example.thermometer.SteadyThermometerImpl;
import org.dfra.example.thermometer.Thermometer;
import org.dfra.example.thermometer.ThermometerProxy;
import org.dfra.example.thermometer.ThermometerServer;
import org.dfra.river.transport.TransportTraffic;
import org.dfra.testing.EmbeddedReggie;
import org.dfra.testing.ServedModule;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.EnabledIfSystemProperty;
import org.junit.jupiter.api.extension.RegisterExtension;

/** The modules of one virtual machine share what they need for their registrations. */
@Timeout(180)
class ManyModulesTest {

  private static final Duration PATIENCE = Duration.ofSeconds(60);
  private static final int MODULES = 30;

  /** 30 searches, joins and renewals of their own had about 370. */
  private static final int MAX_ADDED_THREADS = 32;

  @RegisterExtension final EmbeddedReggie one = new EmbeddedReggie();
  @RegisterExtension final EmbeddedReggie two = new EmbeddedReggie();
  @RegisterExtension final EmbeddedReggie three = new EmbeddedReggie();

  private final List<ThermometerServer> servers = new ArrayList<>();

  @AfterEach
  void end() {
    servers.forEach(ThermometerServer::close);
  }

  private static int threads() {
    return ManagementFactory.getThreadMXBean().getThreadCount();
  }

  private List<EmbeddedReggie> reggies() {
    return List.of(one, two, three);
  }

  private static int registered(EmbeddedReggie reggie) throws RemoteException {
    Class<?>[] kinds = {Thermometer.class};
    return reggie.registrar().lookup(new ServiceTemplate(null, kinds, null), 0).totalMatches;
  }

  @Test
  @EnabledIfSystemProperty(named = "dfra.full", matches = "true", disabledReason = "takes a minute")
  void areRegisteredEverywhereWithFewThreadsAndFewCalls() throws Exception {
    int before = threads();
    List<String> locators = reggies().stream().map(EmbeddedReggie::locator).toList();
    for (int i = 0; i < MODULES; i++) {
      servers.add(
          ServedModule.of(
                  ThermometerServer.class, ThermometerProxy.class, SteadyThermometerImpl.class)
              .named("module" + i)
              .withId(UUID.randomUUID())
              .joining(locators)
              .serve());
    }
    for (EmbeddedReggie each : reggies()) {
      await().atMost(PATIENCE).until(() -> registered(each) == MODULES);
    }
    await("threads of registrations end when idle")
        .atMost(PATIENCE)
        .until(() -> threads() - before <= MAX_ADDED_THREADS);

    TransportTraffic began = TransportTraffic.now();
    long start = System.nanoTime();
    Duration leases = Duration.ofMillis(3 * EmbeddedReggie.LEASE_MILLIS);
    await().pollDelay(leases).atMost(PATIENCE).until(() -> true);
    long calls = TransportTraffic.now().since(began).callsSent();
    double seconds = (System.nanoTime() - start) / 1e9;
    for (EmbeddedReggie each : reggies()) {
      assertThat(registered(each)).as("after three leases").isEqualTo(MODULES);
    }
    // Renewed alone, each of the 90 leases would be renewed by a call every 5 / 3 s.
    double renewedAlone = 90 * seconds / (EmbeddedReggie.LEASE_MILLIS / 3e3);
    assertThat((double) calls).as("calls in %.1f s", seconds).isBetween(3.0, renewedAlone / 5);
  }
}
