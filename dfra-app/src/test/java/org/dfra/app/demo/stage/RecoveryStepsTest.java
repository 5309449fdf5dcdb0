package org.dfra.app.demo.stage;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.HashSet;
import java.util.Set;
import java.util.concurrent.atomic.AtomicLong;
import org.junit.jupiter.api.Test;

class RecoveryStepsTest {

  private final AtomicLong now = new AtomicLong(7);
  private final Set<String> taken = new HashSet<>();
  private final RecoverySteps steps =
      new RecoverySteps(now::get)
          .step("noticed", () -> taken.contains("noticed"))
          .step("new process", () -> taken.contains("new process"))
          .step("heard", () -> taken.contains("heard"));

  private void after(long millis, String... more) throws Exception {
    now.addAndGet(Duration.ofMillis(millis).toNanos());
    taken.addAll(Set.of(more));
    steps.look();
  }

  @Test
  void saysWhenEachWasSeenFirstAndWhichWasNot() throws Exception {
    after(100);
    assertThat(steps).hasToString("noticed not seen, new process not seen, heard not seen");
    after(200, "new process");
    after(700, "noticed");
    after(1000);
    assertThat(steps).hasToString("new process 0.3 s, noticed 1.0 s, heard not seen");
    taken.remove("noticed");
    after(1500, "heard");
    assertThat(steps).hasToString("new process 0.3 s, noticed 1.0 s, heard 3.5 s");
  }
}
