package org.dfra.attack.fuzz;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import org.dfra.benchmarks.attack.BombServer;
import org.dfra.benchmarks.task.TaskProcess;
import org.dfra.testing.EmbeddedReggie;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.extension.RegisterExtension;
import org.junit.jupiter.api.io.TempDir;

/**
 * A client with a small heap asks at a locator where a stranger answers, who claims arrays that no
 * heap holds. It refuses them, and finds the lookup service that answers there later.
 */
@Timeout(240)
class DiscoveryBombIT {

  private static final Duration PATIENCE = Duration.ofSeconds(90);
  private static final int BOMBS = 20;

  @RegisterExtension static final EmbeddedReggie REGGIE = new EmbeddedReggie();

  @TempDir Path folder;

  @Test
  void aClientSurvivesAnAnswerThatClaimsMoreThanItsHeap() throws Exception {
    byte[] groups = BombServer.claimOfGroups();
    byte[] numbers = BombServer.claimOfNumbers();
    byte[] elements = BombServer.claimOfElements();
    assertThat(groups.length).as("bytes of the bomb").isLessThan(300);
    assertThat(elements.length).as("bytes of the lists").isLessThan(600);
    try (BombServer server =
            BombServer.start(
                EmbeddedReggie.HOST, REGGIE.port(), List.of(groups, numbers, elements), BOMBS);
        TaskProcess client =
            TaskProcess.start(
                List.of(),
                List.of("-Xmx64m"),
                FuzzedRobot.class,
                EmbeddedReggie.HOST,
                folder.resolve("module.ser").toString())) {
      String unused = client.awaitLine("serves", PATIENCE);
      client.write("discover " + server.locator());
      client.write("stop"); // once it has found one, and then once more
      assertThat(client.awaitLine("found", PATIENCE))
          .isEqualTo("found " + REGGIE.registrar().getServiceID());
      assertThat(server.sentCount()).isEqualTo(BOMBS);
      assertThat(client.lines())
          .as("threads that ended; %s", client.log())
          .noneMatch(line -> line.startsWith(FuzzedRobot.DIED));
    }
  }
}
