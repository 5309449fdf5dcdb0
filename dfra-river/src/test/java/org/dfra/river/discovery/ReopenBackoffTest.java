package org.dfra.river.discovery;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.concurrent.FutureTask;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

@Timeout(60)
class ReopenBackoffTest {

  private final ReopenBackoff backoff = new ReopenBackoff();

  @Test
  void waitsLongerAfterEachFailureInARowAndLogsTheFirst() {
    assertThat(backoff.pause()).isZero();
    assertThat(backoff.failed()).as("the first in a row").isTrue();
    assertThat(backoff.pause()).isEqualTo(ReopenBackoff.SHORTEST);
    assertThat(backoff.failed()).as("the first in a row").isFalse();
    assertThat(backoff.pause()).isEqualTo(ReopenBackoff.SHORTEST.multipliedBy(2));
    for (int i = 0; i < 100; i++) {
      Duration before = backoff.pause();
      assertThat(backoff.failed()).isFalse();
      assertThat(backoff.pause()).isBetween(before, ReopenBackoff.LONGEST);
    }
    assertThat(backoff.pause()).isEqualTo(ReopenBackoff.LONGEST);
    assertThat(backoff.succeeded()).as("it had failed").isTrue();
    assertThat(backoff.succeeded()).isFalse();
    assertThat(backoff.failed()).as("the first in a row").isTrue();
    assertThat(backoff.pause()).isEqualTo(ReopenBackoff.SHORTEST);
  }

  @Test
  void aCloseEndsTheLongestWaitAtOnce() throws Exception {
    for (int i = 0; i < 100; i++) {
      boolean unused = backoff.failed();
    }
    FutureTask<Boolean> wait = new FutureTask<>(backoff::await);
    Thread listener = new Thread(wait, "waits to open its socket");
    listener.setDaemon(true);
    listener.start();
    backoff.close();
    assertThat(wait.get(10, TimeUnit.SECONDS)).as("whether to open it again").isFalse();
    assertThat(backoff.isClosed()).isTrue();
  }
}
