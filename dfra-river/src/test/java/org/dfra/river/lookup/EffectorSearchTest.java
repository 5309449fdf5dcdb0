package org.dfra.river.lookup;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.UUID;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import org.dfra.river.discovery.AnsweringServer;
import org.dfra.river.discovery.FakeRegistrar;
import org.dfra.river.lookup.EffectorSearch.ListedEffector;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** Which lookup services an emergency stop reads. */
@Timeout(60)
class EffectorSearchTest {

  private static final FakeRegistrar HONEST = new FakeRegistrar(7, "field");
  private static final FakeRegistrar COPY = new FakeRegistrar(7, "of a stranger");

  private final List<AnsweringServer> servers = new ArrayList<>();
  private final BlockingQueue<UUID> found = new LinkedBlockingQueue<>();
  private final EffectorSearch.Listener listener =
      new EffectorSearch.Listener() {
        @Override
        public void registrarFound(UUID registrar, String host) {
          found.add(registrar);
        }

        @Override
        public void found(ListedEffector effector) {
          throw new AssertionError("neither lists an effector: " + effector);
        }
      };

  @AfterEach
  void close() throws IOException {
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

  /** A stranger's lookup service that claims the service ID of a robot's does not hide it. */
  @Test
  void bothLookupServicesOfOneServiceIdAreRead() throws Exception {
    List<String> places = List.of(serve(COPY), serve(HONEST));
    try (EffectorSearch search =
        new EffectorSearch(List.of(), places, List.of(), List.of(), listener)) {
      assertThat(search.awaitRead(Duration.ofSeconds(20))).as("places without one").isEmpty();
      assertThat(found).as("each has a key of its own").hasSize(2).doesNotHaveDuplicates();
      assertThat(search.unread()).isEmpty();
    }
  }
}
