package org.dfra.benchmarks.call;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.awaitility.Awaitility.await;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.time.Duration;
import java.util.Map;
import java.util.concurrent.SynchronousQueue;
import org.dfra.benchmarks.call.CallMeasurement.ProcessUse;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

@Timeout(60)
class ProcessCountersTest {

  private static final long SELF = ProcessHandle.current().pid();

  private static ProcessCounters counters(Map<Long, Long> switches, long cpuMillis) {
    return new ProcessCounters(switches, Duration.ofMillis(cpuMillis));
  }

  @Test
  void countsTheThreadsThatWaitForEachOther() throws Exception {
    assumeTrue(ProcessCounters.arePossible(), "this computer does not count context switches");
    SynchronousQueue<Integer> questions = new SynchronousQueue<>();
    SynchronousQueue<Integer> answers = new SynchronousQueue<>();
    Thread answering =
        new Thread(
            () -> {
              try {
                for (int i = questions.take(); i >= 0; i = questions.take()) {
                  answers.put(i);
                }
              } catch (InterruptedException e) {
                Thread.currentThread().interrupt();
              }
            });
    answering.start();
    ProcessCounters before = ProcessCounters.of(SELF);
    // A thread may find its partner without waiting, but not each time on any computer.
    await()
        .atMost(Duration.ofSeconds(30))
        .until(
            () -> {
              for (int i = 0; i < 1000; i++) {
                questions.put(i);
                assertThat(answers.take()).isEqualTo(i);
              }
              return ProcessCounters.of(SELF).switchesSince(before) >= 1000;
            });
    assertThat(ProcessCounters.of(SELF).cpuMicrosSince(before)).isGreaterThanOrEqualTo(0);
    questions.put(-1);
    answering.join();
    await()
        .atMost(Duration.ofSeconds(30))
        .untilAsserted(() -> assertThat(ProcessCounters.of(SELF).endedSince(before)).isPositive());
  }

  @Test
  void addsNewThreadsAndLeavesEndedOnesOut() {
    ProcessCounters before = counters(Map.of(1L, 100L, 2L, 50L), 1000);
    ProcessCounters after = counters(Map.of(1L, 130L, 3L, 7L), 1020);
    assertThat(after.switchesSince(before)).isEqualTo(30 + 7);
    assertThat(after.endedSince(before)).isEqualTo(1);
    assertThat(after.cpuMicrosSince(before)).isEqualTo(20_000);
  }

  @Test
  void countsSwitchesOnlyOfPartsInWhichNoThreadEnded() {
    ProcessUseCounter counter = new ProcessUseCounter();
    counter.add(counters(Map.of(1L, 0L, 2L, 0L), 0), counters(Map.of(1L, 10L), 10), 0, 10);
    assertThat(counter.use()).isEqualTo(new ProcessUse(1, false, 1000));
    counter.add(counters(Map.of(1L, 10L), 10), counters(Map.of(1L, 50L), 20), 1, 10);
    assertThat(counter.use().isComplete()).as("a Java thread started and ended").isFalse();
    counter.add(counters(Map.of(1L, 50L), 30), counters(Map.of(1L, 80L), 50), 0, 10);
    assertThat(counter.use().switchesPerCall()).isEqualTo(3);
    assertThat(counter.use().isComplete()).isTrue();
    assertThat(counter.use().cpuPerCall())
        .as("of all parts, without the time between them")
        .isCloseTo(40_000 / 30.0, within(1e-9));
  }

  @Test
  void isNoNumberWhereNothingIsCounted() {
    ProcessUseCounter counter = new ProcessUseCounter();
    counter.add(counters(Map.of(), 0), counters(Map.of(), 10), 0, 10);
    assertThat(counter.use().switchesPerCall()).isNaN();
  }
}
