package org.dfra.river.lookup;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.concurrent.atomic.AtomicInteger;
import org.dfra.river.fixture.SteppedTime;
import org.junit.jupiter.api.Test;

/** Waits of River's own are short, and monotonic. */
class LookupTimingsTest {

  private final SteppedTime time = new SteppedTime();
  private final LookupTimings.BoundedWakeupManager wakeups =
      new LookupTimings.BoundedWakeupManager(time);
  private final AtomicInteger woken = new AtomicInteger();

  @Test
  void wakesInTimeWhereTheClockIsSetBackMeanwhile() {
    long hour = Duration.ofHours(1).toMillis();
    // As if the clock had been set back by an hour after the time was reckoned.
    wakeups.schedule(System.currentTimeMillis() + hour + 500, woken::incrementAndGet);
    time.pass(LookupTimings.MAX_RETRY_DELAY);
    assertThat(woken).hasValue(1);
    assertThat(wakeups.isEmpty()).isTrue();
  }

  @Test
  void wakesNobodyWhoCancelled() {
    wakeups.cancel(wakeups.schedule(System.currentTimeMillis() + 500, woken::incrementAndGet));
    wakeups.schedule(System.currentTimeMillis() + 500, woken::incrementAndGet);
    wakeups.stop();
    time.pass(Duration.ofSeconds(10));
    assertThat(woken).hasValue(0);
  }
}
