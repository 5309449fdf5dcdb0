package org.dfra.benchmarks;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import java.time.Duration;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

@Timeout(60)
class ThreadCounterTest {

  private static final Duration POLL = Duration.ofMillis(5);
  private static final Duration QUIET = Duration.ofMillis(50);
  private static final Duration PATIENCE = Duration.ofSeconds(30);

  @Test
  void keepsAMaximumThatIsOverWhenItIsQueried() throws Exception {
    AtomicInteger threads = new AtomicInteger(10);
    AtomicInteger samples = new AtomicInteger();
    ThreadCounter.Source source =
        () -> {
          samples.incrementAndGet();
          return threads.get();
        };
    try (ThreadCounter counter = ThreadCounter.start(source, POLL)) {
      assertThat(counter.maximum()).isEqualTo(10);
      threads.set(30);
      int before = samples.get();
      await().until(() -> samples.get() > before + 1); // a whole sample after it
      threads.set(20);
      assertThat(counter.maximum()).isEqualTo(30);
    }
  }

  @Test
  void waitsUntilTheCountDoesNotChange() throws Exception {
    AtomicInteger looks = new AtomicInteger();
    ThreadCounter.Source starting = () -> Math.max(10, 40 - looks.incrementAndGet());
    assertThat(ThreadCounter.awaitSettled(starting, QUIET, POLL, PATIENCE)).isTrue();
    assertThat(looks.get()).as("looks, of which 29 found a change").isGreaterThan(30);
    assertThat(ThreadCounter.awaitSettled(looks::incrementAndGet, QUIET, POLL, QUIET)).isFalse();
  }

  @Test
  void countsThreadsOfProcesses() throws Exception {
    ThreadCounter.Source own = ThreadCounter.Source.of(List.of(ProcessHandle.current().pid()));
    CountDownLatch over = new CountDownLatch(1);
    try (ThreadCounter counter = ThreadCounter.start(own, POLL)) {
      int before = own.count();
      for (int i = 0; i < 50; i++) {
        Thread thread = new Thread(() -> awaitOver(over), "counted " + i);
        thread.setDaemon(true);
        thread.start();
      }
      assertThat(counter.maximum()).isGreaterThan(before + 25); // others may end meanwhile
    } finally {
      over.countDown();
    }
  }

  private static void awaitOver(CountDownLatch over) {
    try {
      over.await();
    } catch (InterruptedException e) {
      throw new IllegalStateException(e);
    }
  }
}
