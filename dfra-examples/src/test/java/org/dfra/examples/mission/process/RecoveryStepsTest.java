package org.dfra.examples.mission.process;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import java.io.IOException;
import java.time.Duration;
import java.util.HashSet;
import java.util.Set;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.atomic.AtomicLong;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

class RecoveryStepsTest {

  private final AtomicLong now = new AtomicLong(7);
  private final Set<String> taken = new HashSet<>();
  private final RecoverySteps steps =
      new RecoverySteps(now::get)
          .step("noticed", () -> taken.contains("noticed"))
          .step("new process", () -> taken.contains("new process"))
          .step("received", this::isReceived);

  private boolean isReceived() throws IOException {
    if (taken.contains("no answer")) {
      throw new IOException("the module is too busy");
    }
    return taken.contains("received");
  }

  private void after(long millis, String... more) throws Exception {
    now.addAndGet(Duration.ofMillis(millis).toNanos());
    taken.addAll(Set.of(more));
    steps.look();
  }

  @Test
  void saysWhenEachWasSeenFirstAndWhichWasNot() throws Exception {
    after(100);
    assertThat(steps).hasToString("noticed not seen, new process not seen, received not seen");
    after(200, "new process");
    after(700, "noticed");
    after(1000);
    assertThat(steps).hasToString("new process 0.3 s, noticed 1.0 s, received not seen");
    taken.remove("noticed");
    after(500, "received", "no answer");
    assertThat(steps)
        .as("where nobody answers")
        .hasToString("new process 0.3 s, noticed 1.0 s, received not seen");
    taken.remove("no answer");
    after(1000);
    assertThat(steps).hasToString("new process 0.3 s, noticed 1.0 s, received 3.5 s");
  }

  @Test
  @Timeout(60)
  void looksByItselfUntilAllIsTaken() throws Exception {
    CountDownLatch looked = new CountDownLatch(3);
    try (RecoverySteps watched =
        new RecoverySteps()
            .step(
                "third look",
                () -> {
                  looked.countDown();
                  return looked.getCount() == 0;
                })
            .step("last", () -> looked.getCount() == 0)
            .watch()) {
      looked.await();
      await().until(() -> watched.toString().endsWith(" s"));
      assertThat(watched.toString()).matches("third look [0-9.]+ s, last [0-9.]+ s");
    }
  }
}
