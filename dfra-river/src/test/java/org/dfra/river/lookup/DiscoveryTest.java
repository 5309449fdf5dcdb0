package org.dfra.river.lookup;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import java.io.IOException;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import net.jini.config.EmptyConfiguration;
import net.jini.core.discovery.LookupLocator;
import net.jini.core.lookup.ServiceRegistrar;
import org.dfra.river.discovery.AnsweringServer;
import org.dfra.river.discovery.FakeRegistrar;
import org.dfra.river.discovery.LocatedRegistrar;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** Lookup services at locators, some of which claim the service ID of another one. */
@Timeout(60)
class DiscoveryTest {

  private static final Duration PATIENCE = Duration.ofSeconds(20);
  private static final Duration RETRY = Duration.ofMillis(50);
  private static final FakeRegistrar HONEST = new FakeRegistrar(7, "field");
  private static final FakeRegistrar COPY = new FakeRegistrar(7, "of a stranger");

  private final List<AnsweringServer> servers = new ArrayList<>();
  private Discovery discovery;

  @AfterEach
  void end() throws IOException {
    if (discovery != null) {
      discovery.terminate();
    }
    for (AnsweringServer each : servers) {
      each.close();
    }
  }

  private String serve(FakeRegistrar registrar) throws IOException {
    byte[] answer = AnsweringServer.answer(registrar, List.of("field"));
    AnsweringServer server = new AnsweringServer(out -> out.write(answer));
    servers.add(server);
    return "jini://" + server.host() + ":" + server.port();
  }

  /** Begins, and waits until each locator was answered. */
  private void discover(String... locators) throws Exception {
    discovery = Discovery.start(List.of(), List.of(locators), RETRY, EmptyConfiguration.INSTANCE);
    await()
        .atMost(PATIENCE)
        .until(
            () -> discovery.registrarsByLocator().values().stream().allMatch(Optional::isPresent));
  }

  private List<String> places() {
    return Arrays.stream(discovery.getRegistrars())
        .map(each -> "jini://" + ((LocatedRegistrar) each).hostAndPort())
        .toList();
  }

  @Test
  void aCopyOfAServiceIdHidesNoLookupService() throws Exception {
    String stranger = serve(COPY);
    discover(stranger);
    await().atMost(PATIENCE).until(() -> places().equals(List.of(stranger)));
    String honest = serve(HONEST);
    discovery.addLocators(new LookupLocator[] {new LookupLocator(honest)});
    await().atMost(PATIENCE).until(() -> places().equals(List.of(stranger, honest)));
    assertThat(Arrays.stream(discovery.getRegistrars()).map(ServiceRegistrar::getServiceID))
        .containsOnly(HONEST.getServiceID());
  }

  @Test
  void whatBecomesOfACopyConcernsNoOther() throws Exception {
    String stranger = serve(COPY);
    String honest = serve(HONEST);
    discover(stranger, honest);
    await().atMost(PATIENCE).until(() -> places().size() == 2);
    discovery.removeLocators(new LookupLocator[] {new LookupLocator(stranger)});
    assertThat(places()).containsExactly(honest);
  }

  @Test
  void oneLookupServiceAtTwoLocatorsIsOne() throws Exception {
    String one = serve(HONEST);
    String two = serve(HONEST);
    discover(one, two);
    String other = serve(new FakeRegistrar(8, "field"));
    discovery.addLocators(new LookupLocator[] {new LookupLocator(other)});
    await().atMost(PATIENCE).until(() -> places().contains(other));
    assertThat(places()).hasSize(2);
  }
}
