package org.dfra.slice;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.rmi.RemoteException;
import java.time.Duration;
import java.util.Arrays;
import java.util.List;
import java.util.UUID;
import net.jini.core.lookup.ServiceID;
import net.jini.core.lookup.ServiceItem;
import net.jini.core.lookup.ServiceTemplate;
import net.jini.lookup.entry.Name;
import org.dfra.example.thermometer.SteadyThermometerImpl;
import org.dfra.example.thermometer.Thermometer;
import org.dfra.example.thermometer.ThermometerProxy;
import org.dfra.example.thermometer.ThermometerServer;
import org.dfra.river.entry.ModuleEntry;
import org.dfra.river.lookup.JiniModuleDirectory;
import org.dfra.testing.EmbeddedReggie;
import org.dfra.testing.ServedModule;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.RegisterExtension;

class LookupJoinTest {

  private static final Duration PATIENCE = Duration.ofSeconds(30);

  @RegisterExtension static final EmbeddedReggie REGGIE = new EmbeddedReggie();

  private static ServedModule<ThermometerServer> thermometer() {
    return ServedModule.of(
        ThermometerServer.class, ThermometerProxy.class, SteadyThermometerImpl.class);
  }

  @Test
  void isRegisteredUnderItsIdentityAndNameAndOnlyWhileItServes() throws Exception {
    ServedModule<ThermometerServer> module = thermometer().joining(REGGIE);
    ServiceID expected = serviceId(module.activation().id());
    for (int life = 1; life <= 2; life++) {
      try (ThermometerServer server = module.serve()) {
        await().atMost(PATIENCE).until(() -> !registered(REGGIE).isEmpty());
        List<ServiceItem> items = registered(REGGIE);
        assertThat(items).as("life %d of %s", life, server).hasSize(1);
        assertThat(items.get(0).serviceID).isEqualTo(expected);
        assertThat(items.get(0).attributeSets)
            .contains(new Name("robot/module"))
            .hasAtLeastOneElementOfType(ModuleEntry.class);
      }
      assertThat(registered(REGGIE)).as("after life %d", life).isEmpty();
    }
  }

  @Test
  void staysRegisteredBeyondItsLease() throws Exception {
    try (ThermometerServer server = thermometer().joining(REGGIE).serve()) {
      await().atMost(PATIENCE).until(() -> !registered(REGGIE).isEmpty());
      await()
          .pollDelay(Duration.ofMillis(EmbeddedReggie.LEASE_MILLIS + 500))
          .atMost(PATIENCE)
          .until(() -> true);
      await()
          .atMost(PATIENCE)
          .untilAsserted(
              () ->
                  assertThat(registered(REGGIE)).as("%s after its first lease", server).hasSize(1));
    }
  }

  @Test
  void joinsALookupServiceThatAppearsLater() throws Exception {
    int port;
    try (EmbeddedReggie gone = new EmbeddedReggie().start()) {
      port = gone.port();
    }
    ServedModule<ThermometerServer> module = thermometer().joining("jini://127.0.0.1:" + port);
    try (ThermometerServer server = module.serve();
        JiniModuleDirectory directory =
            new JiniModuleDirectory("127.0.0.1", List.of(), List.of("jini://127.0.0.1:" + port))) {
      assertThat(directory.find(Thermometer.class, Duration.ofMillis(300)))
          .as("%s before there is a lookup service", server)
          .isEmpty();
      try (EmbeddedReggie late = new EmbeddedReggie(port).start()) {
        assertThat(directory.find(Thermometer.class, PATIENCE)).isPresent();
        assertThat(registered(late)).hasSize(1);
      }
      try (EmbeddedReggie other = new EmbeddedReggie(port).start()) { // it knows nothing
        await().atMost(PATIENCE).untilAsserted(() -> assertThat(registered(other)).hasSize(1));
      }
    }
  }

  @Test
  void joinsALookupServiceThatWasSilentAtFirst() throws Exception {
    try (ServerSocket silent = new ServerSocket(0, 0, InetAddress.getByName("127.0.0.1"))) {
      int port = silent.getLocalPort(); // the system accepts connections, nobody ever answers
      ServedModule<ThermometerServer> module = thermometer().joining("jini://127.0.0.1:" + port);
      try (ThermometerServer server = module.serve();
          Socket first = silent.accept()) {
        silent.close();
        try (EmbeddedReggie late = new EmbeddedReggie(port).start()) {
          await()
              .atMost(PATIENCE)
              .untilAsserted(
                  () -> assertThat(registered(late)).as("%s at %s", server, first).hasSize(1));
        }
      }
    }
  }

  private static List<ServiceItem> registered(EmbeddedReggie reggie) throws RemoteException {
    Class<?>[] kinds = {Thermometer.class};
    return Arrays.asList(
        reggie.registrar().lookup(new ServiceTemplate(null, kinds, null), 10).items);
  }

  private static ServiceID serviceId(UUID id) {
    return new ServiceID(id.getMostSignificantBits(), id.getLeastSignificantBits());
  }
}
