package org.dfra.core.behavior;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.awaitility.Awaitility.await;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.PriorityQueue;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import org.dfra.time.Scheduler;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

@Timeout(60)
class ControlLoopTest {

  private static final Duration PATIENCE = Duration.ofSeconds(20);

  /** Lock-step: a cycle that takes time advances the time itself. */
  private static final class Lane implements Scheduler {
    private record Due(long at, long number, Runnable task) implements Comparable<Due> {
      @Override
      public int compareTo(Due other) {
        return at != other.at ? Long.compare(at, other.at) : Long.compare(number, other.number);
      }
    }

    private final PriorityQueue<Due> tasks = new PriorityQueue<>();
    private long now;
    private long number;

    @Override
    public long nanos() {
      return now;
    }

    @Override
    public ScheduledTask after(long nanos, Runnable task) {
      Due due = new Due(now + Math.max(0, nanos), number++, task);
      tasks.add(due);
      return () -> tasks.remove(due);
    }

    @Override
    public boolean isLockStep() {
      return true;
    }

    void runTo(double seconds) {
      long end = Math.round(seconds * 1e9);
      while (!tasks.isEmpty() && tasks.peek().at() <= end) {
        Due next = tasks.remove();
        now = Math.max(now, next.at());
        next.task().run();
      }
      now = Math.max(now, end);
    }
  }

  private final Lane time = new Lane();
  private final List<Double> turns = new ArrayList<>();

  private double seconds() {
    return time.nanos() / 1e9;
  }

  @Test
  void keepsItsRate() {
    ControlLoop loop = new ControlLoop("test", time, 10, () -> turns.add(seconds()));
    loop.start();
    loop.start(); // does nothing
    time.runTo(0.95);
    assertThat(turns).containsExactly(0.0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9);
    assertThat(loop.cycles()).isEqualTo(10);
    assertThat(loop.missedCycles()).isZero();
    assertThat(loop.lateness(1)).isZero();
  }

  @Test
  void countsTurnsThatItMissedAndIsBackInStep() {
    ControlLoop loop =
        new ControlLoop(
            "test",
            time,
            10,
            () -> {
              turns.add(seconds());
              if (turns.size() == 3) {
                time.now += 350_000_000; // from 0.2 to 0.55
              }
            });
    loop.start();
    time.runTo(0.75);
    assertThat(turns).containsExactly(0.0, 0.1, 0.2, 0.55, 0.6, 0.7);
    assertThat(loop.missedCycles()).as("those of 0.3 and 0.4").isEqualTo(2);
    assertThat(loop.lateness(1)).as("that of 0.5").isCloseTo(0.05, within(1e-9));
    assertThat(loop.lateness(5 / 6.0)).as("the other five").isZero();
  }

  @Test
  void stopsWithinACycleAndStartsAgain() {
    ControlLoop[] loop = new ControlLoop[1];
    loop[0] =
        new ControlLoop(
            "test",
            time,
            10,
            () -> {
              turns.add(seconds());
              if (turns.size() == 2) {
                loop[0].stop();
              }
            });
    loop[0].start();
    time.runTo(1);
    assertThat(turns).containsExactly(0.0, 0.1);
    loop[0].start();
    time.runTo(1.15);
    assertThat(turns).containsExactly(0.0, 0.1, 1.0, 1.1);
    loop[0].close();
    time.runTo(2);
    assertThat(turns).hasSize(4);
  }

  @Test
  void mayBeStartedAgainAfterATurnThatThrew() {
    ControlLoop loop =
        new ControlLoop(
            "test",
            time,
            10,
            () -> {
              turns.add(seconds());
              if (turns.size() == 1) {
                throw new IllegalStateException("a fault");
              }
            });
    loop.start();
    try {
      time.runTo(0.5);
    } catch (IllegalStateException e) {
      assertThat(e).hasMessage("a fault");
    }
    time.runTo(1);
    assertThat(turns).hasSize(1);
    loop.start();
    time.runTo(1.25);
    assertThat(turns).hasSize(4);
  }

  @Test
  void turnsNeverOverlapThoughItIsStoppedAndStartedWithinThem() throws Exception {
    AtomicInteger within = new AtomicInteger();
    AtomicInteger most = new AtomicInteger();
    CountDownLatch begun = new CountDownLatch(1);
    CountDownLatch mayEnd = new CountDownLatch(1);
    AtomicInteger count = new AtomicInteger();
    try (ControlLoop loop =
        new ControlLoop(
            "test-loop",
            Scheduler.system(),
            50,
            () -> {
              most.accumulateAndGet(within.incrementAndGet(), Math::max);
              begun.countDown();
              try {
                mayEnd.await(20, TimeUnit.SECONDS);
              } catch (InterruptedException e) {
                Thread.currentThread().interrupt();
              }
              within.decrementAndGet();
              count.incrementAndGet();
            })) {
      loop.start();
      assertThat(begun.await(20, TimeUnit.SECONDS)).isTrue();
      loop.stop();
      loop.start(); // its cycle has to wait for the one that runs
      mayEnd.countDown();
      await().atMost(PATIENCE).until(() -> count.get() > 5);
      assertThat(most.get()).isEqualTo(1);
    }
    await()
        .atMost(PATIENCE)
        .until(
            () ->
                Thread.getAllStackTraces().keySet().stream()
                    .noneMatch(thread -> thread.getName().equals("test-loop")));
  }
}
