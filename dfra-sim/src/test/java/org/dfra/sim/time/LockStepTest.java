package org.dfra.sim.time;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicReference;
import java.util.concurrent.locks.Condition;
import java.util.concurrent.locks.ReentrantLock;
import org.dfra.drivers.link.Ticker;
import org.dfra.time.Scheduler.ScheduledTask;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

@Timeout(60)
class LockStepTest {

  private static final Instant BEGIN = Instant.parse("2026-01-21T07:33:29Z");
  private static final Duration SECOND = Duration.ofSeconds(1);
  private static final Duration LONG = Duration.ofSeconds(20);

  private final LockStep time = new LockStep(BEGIN);
  private final List<String> seen = Collections.synchronizedList(new ArrayList<>());
  private final ReentrantLock lock = new ReentrantLock();
  private final Condition condition = time.newCondition(lock);

  private void see(String what) {
    seen.add(time.nanos() / 1_000_000 + " " + what);
  }

  private static long millis(long count) {
    return count * 1_000_000;
  }

  /** One wait by this time, at most so long. */
  private void await(long millis) {
    lock.lock();
    try {
      time.await(condition, millis(millis));
    } catch (InterruptedException e) {
      see("interrupted");
    } finally {
      lock.unlock();
    }
  }

  private void signal() {
    lock.lock();
    try {
      condition.signalAll();
    } finally {
      lock.unlock();
    }
  }

  @Test
  void standsUntilItIsMovedOn() {
    assertThat(time.instant()).isEqualTo(BEGIN);
    time.advance(Duration.ofMillis(1500));
    assertThat(time.instant()).isEqualTo(BEGIN.plusMillis(1500));
    assertThat(time.nanos()).isEqualTo(millis(1500));
    time.advanceTo(BEGIN.plusSeconds(2));
    assertThat(time.instant()).isEqualTo(BEGIN.plusSeconds(2));
    assertThatThrownBy(() -> time.advanceTo(BEGIN))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessage("time cannot go back by PT2S");
  }

  @Test
  void isADriversTickerAndItsScheduler() {
    assertThat(Ticker.of(time)).isSameAs(time);
    assertThat(time.isLockStep()).isTrue();
  }

  @Test
  void tasksComeByTimeAndThenInTheOrderTheyWereGiven() {
    time.after(millis(20), () -> see("c"));
    time.after(millis(10), () -> see("a"));
    time.after(
        millis(10),
        () -> {
          see("b");
          time.after(0, () -> see("b2"));
          time.after(-5, () -> see("b3"));
        });
    ScheduledTask never = time.after(millis(15), () -> see("never"));
    never.cancel();
    time.advance(Duration.ofMillis(19));
    assertThat(seen).containsExactly("10 a", "10 b", "10 b2", "10 b3");
    time.advance(Duration.ofMillis(1)); // what is due at the end is due
    assertThat(seen).endsWith("20 c").hasSize(5);
  }

  @Test
  void repeatedTasksKeepTheirPlaceWhateverTheirPeriods() {
    ScheduledTask slow = time.every(Duration.ofMillis(20), () -> see("slow"));
    time.every(Duration.ofMillis(10), () -> see("fast"));
    time.after(millis(20), () -> see("once"));
    time.advance(Duration.ofMillis(20));
    assertThat(seen).containsExactly("10 fast", "20 slow", "20 fast", "20 once");
    slow.cancel();
    time.advance(Duration.ofMillis(20));
    assertThat(seen).endsWith("30 fast", "40 fast");
    assertThatThrownBy(() -> time.every(Duration.ZERO, () -> {}))
        .hasMessage("period PT0S is not longer than 0");
  }

  @Test
  void whatATaskThrowsEndsTheStepThere() {
    time.after(
        millis(10),
        () -> {
          throw new IllegalStateException("a fault in the world");
        });
    assertThatThrownBy(() -> time.advance(SECOND)).hasMessage("a fault in the world");
    assertThat(time.instant()).isEqualTo(BEGIN.plusMillis(10));
    time.advance(SECOND);
    assertThat(time.instant()).isEqualTo(BEGIN.plusMillis(1010));
  }

  @Test
  void aThreadWorksOnlyWhileTheTimeIsMovedOn() throws InterruptedException {
    Thread reader =
        time.newThread(
            "reader",
            () -> {
              see("begins");
              await(100);
              see("goes on");
            });
    reader.start();
    assertThat(seen).isEmpty();
    time.advance(Duration.ZERO);
    assertThat(seen).containsExactly("0 begins");
    time.advance(Duration.ofMillis(99));
    assertThat(seen).hasSize(1);
    time.advance(Duration.ofMillis(1));
    assertThat(seen).containsExactly("0 begins", "100 goes on");
    assertThat(time.join(reader, LONG)).isTrue();
  }

  @Test
  void aSignalEndsAWaitAtItsInstant() {
    time.newThread(
            "reader",
            () -> {
              await(1000);
              see("goes on");
            })
        .start();
    time.after(
        millis(300),
        () -> {
          signal();
          see("signals");
        });
    time.advance(SECOND);
    assertThat(seen).containsExactly("300 signals", "300 goes on");
  }

  @Test
  void manyThreadsWorkInTheOrderTheyWereStartedRunByRun() throws InterruptedException {
    List<Thread> threads = new ArrayList<>();
    List<String> expected = new ArrayList<>();
    for (int i = 0; i < 20; i++) {
      int number = i;
      threads.add(
          time.newThread(
              "t" + i,
              () -> {
                for (int round = 0; round < 50; round++) {
                  await(10); // every signal is seen by all, so nobody is early
                  see("t" + number);
                }
              }));
    }
    threads.forEach(Thread::start);
    for (int round = 1; round <= 50; round++) {
      for (int i = 0; i < 20; i++) {
        expected.add(10 * round + " t" + i);
      }
    }
    time.advance(SECOND);
    assertThat(seen).isEqualTo(expected);
    for (Thread thread : threads) {
      assertThat(time.join(thread, LONG)).isTrue();
    }
  }

  @Test
  void theStepperMayWaitAndMovesTheTimeOnMeanwhile() throws InterruptedException {
    time.every(Duration.ofMillis(10), () -> see("ticks"));
    time.after(millis(25), this::signal);
    await(1000);
    assertThat(time.nanos()).isEqualTo(millis(25));
    await(10);
    assertThat(time.nanos()).isEqualTo(millis(35));
    assertThat(seen).containsExactly("10 ticks", "20 ticks", "30 ticks");
  }

  @Test
  void anAskerThatWaitsDoesNotMoveTheTime() throws Exception {
    time.advance(Duration.ZERO); // so this thread is the stepper
    CountDownLatch waits = new CountDownLatch(1);
    CompletableFuture<Long> asker =
        CompletableFuture.supplyAsync(
            () -> {
              waits.countDown();
              await(500);
              return time.nanos();
            });
    assertThat(waits.await(20, TimeUnit.SECONDS)).isTrue();
    assertThat(time.nanos()).isZero();
    while (!asker.isDone()) {
      time.advance(Duration.ofMillis(100));
    }
    assertThat(asker.get()).isGreaterThanOrEqualTo(millis(500));
  }

  @Test
  void waitingAfterTheStepperHasEndedAdvancesTheTime() throws InterruptedException {
    Thread stepper = new Thread(() -> time.advance(SECOND), "stepper");
    stepper.start();
    stepper.join();
    await(500);
    assertThat(time.nanos()).isEqualTo(millis(1500));
  }

  @Test
  void neitherATaskNorAThreadMayMoveTheTime() {
    List<Throwable> refused = Collections.synchronizedList(new ArrayList<>());
    Runnable move =
        () -> {
          try {
            time.advance(SECOND);
          } catch (IllegalStateException e) {
            refused.add(e);
          }
        };
    time.after(0, move);
    time.newThread("reader", move).start();
    time.after(
        0,
        () -> assertThatThrownBy(() -> await(1)).hasMessageContaining("or wait for it in a task"));
    time.advance(SECOND);
    assertThat(refused).hasSize(2);
    assertThat(refused.get(1)).hasMessageStartingWith("reader runs in simulated time");
  }

  @Test
  void anInterruptIsSeenAtItsInstant() {
    Thread reader =
        time.newThread(
            "reader",
            () -> {
              await(1000);
              see("goes on");
            });
    reader.start();
    time.after(millis(200), reader::interrupt);
    time.advance(SECOND);
    assertThat(seen).containsExactly("200 interrupted", "200 goes on");
  }

  @Test
  void joinGivesAThreadTheTurnsItNeedsToEnd() throws InterruptedException {
    AtomicInteger turns = new AtomicInteger();
    Runnable role =
        () -> {
          while (turns.incrementAndGet() < 5) {
            await(1000);
          }
        };
    Thread reader = time.newThread("reader", role);
    reader.start();
    assertThat(time.join(reader, LONG)).isTrue();
    assertThat(time.nanos()).isZero();

    turns.set(0);
    Thread other = time.newThread("other", role);
    other.start();
    AtomicReference<Boolean> ended = new AtomicReference<>();
    time.after(millis(10), () -> ended.set(joined(other)));
    time.advance(Duration.ofMillis(10));
    assertThat(ended).hasValue(true);

    turns.set(0);
    Thread third = time.newThread("third", role);
    third.start();
    Thread closer = time.newThread("closer", () -> ended.set(joined(third)));
    ended.set(false);
    closer.start();
    time.advance(Duration.ofMillis(10));
    assertThat(ended).as("one thread joins another").hasValue(true);
  }

  private boolean joined(Thread thread) {
    try {
      return time.join(thread, LONG);
    } catch (InterruptedException e) {
      return false;
    }
  }

  @Test
  void aThreadThatNeverWaitsAgainIsReportedWithItsStack() throws InterruptedException {
    LockStep impatient = new LockStep(BEGIN, Duration.ofMillis(200));
    CountDownLatch release = new CountDownLatch(1);
    Thread stuck = impatient.newThread("laser reader", () -> blockElsewhere(release));
    stuck.start();
    assertThatThrownBy(() -> impatient.advance(SECOND))
        .isInstanceOf(LockStep.StuckThreadException.class)
        .hasMessageStartingWith("laser reader did not wait again within 0.2 s of real time; ")
        .cause()
        .hasMessage("laser reader is here")
        .satisfies(
            where ->
                assertThat(where.getStackTrace())
                    .anyMatch(frame -> frame.getMethodName().equals("blockElsewhere")));
    assertThatThrownBy(() -> impatient.advance(SECOND))
        .isInstanceOf(LockStep.StuckThreadException.class);
    release.countDown();
    assertThat(impatient.join(stuck, LONG)).isTrue();
    impatient.advance(SECOND); // all is well again
    assertThat(impatient.nanos()).isEqualTo(millis(1000));
  }

  private static void blockElsewhere(CountDownLatch release) {
    try {
      assertThat(release.await(60, TimeUnit.SECONDS)).isTrue();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  @Test
  void timeThatDoesNotGoOnIsReported() {
    time.after(
        millis(5),
        new Runnable() {
          @Override
          public void run() {
            time.after(0, this);
          }

          @Override
          public String toString() {
            return "the circle";
          }
        });
    assertThatThrownBy(() -> time.advance(SECOND))
        .isInstanceOf(IllegalStateException.class)
        .hasMessage(
            "simulated time does not advance: more than 1000000 events have run at one instant, now"
                + " the circle; let it wait before it repeats");
  }

  @Test
  void refusesAConditionThatItCannotSignal() {
    Condition foreign = lock.newCondition();
    lock.lock();
    try {
      assertThatThrownBy(() -> time.await(foreign, 1))
          .isInstanceOf(IllegalArgumentException.class)
          .hasMessageStartingWith(
              "in lock-step a condition must come from Ticker.newCondition of the same time");
    } finally {
      lock.unlock();
    }
  }

  @Test
  void advancesUntilAConditionHolds() {
    AtomicInteger count = new AtomicInteger();
    time.every(Duration.ofMillis(10), count::incrementAndGet);
    assertThat(time.advanceUntil(() -> count.get() == 7, SECOND)).isTrue();
    assertThat(time.nanos()).isEqualTo(millis(70));
    assertThat(time.advanceUntil(() -> count.get() == 70, Duration.ofMillis(30))).isFalse();
    assertThat(time.nanos()).isEqualTo(millis(100));
  }
}
