package org.dfra.core.time;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import org.dfra.core.lease.LeaseRegistry;
import org.dfra.core.lease.LeaseTerms;
import org.dfra.lease.LeaseRole;
import org.dfra.time.Scheduler;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** Where no thread can be started, nothing is lost; by real time. */
@Timeout(60)
class SerialExecutorTest {

  private static final long PATIENCE_SECONDS = 20;

  private final AtomicInteger missing = new AtomicInteger();
  private final List<String> done = new CopyOnWriteArrayList<>();
  private final SerialExecutor executor =
      new SerialExecutor("a test", Scheduler.system(), this::thread);

  /** One that cannot be started as long as threads are missing, as on a computer without any. */
  private Thread thread(Runnable task) {
    return new Thread(task) {
      @Override
      public synchronized void start() {
        if (missing.getAndDecrement() > 0) {
          throw new OutOfMemoryError("unable to create native thread");
        }
        super.start();
      }
    };
  }

  @AfterEach
  void close() {
    executor.close();
  }

  @Test
  void tasksThatNoThreadCouldBeStartedForAreRunLaterAndInOrder() throws Exception {
    missing.set(2);
    CountDownLatch all = new CountDownLatch(3);
    for (String each : List.of("a", "b", "c")) {
      executor.execute(
          () -> {
            done.add(each);
            all.countDown();
          });
    }
    assertThat(all.await(PATIENCE_SECONDS, TimeUnit.SECONDS)).isTrue();
    assertThat(done).containsExactly("a", "b", "c");
  }

  @Test
  void saysWhetherItHasAThreadAndBeginsItWhereItCan() {
    missing.set(1);
    assertThat(executor.isPrepared()).isFalse();
    assertThat(executor.isPrepared()).isTrue();
    missing.set(1);
    assertThat(executor.isPrepared()).as("one is enough").isTrue();
    assertThat(missing).as("no other was started").hasValue(1);
    assertThat(executor.executeWithin(() -> done.add("run"), Duration.ofSeconds(20))).isTrue();
    assertThat(done).containsExactly("run");
  }

  @Test
  void whatWaitsForAThreadIsRunAlsoAfterTheEnd() throws Exception {
    missing.set(1);
    CountDownLatch run = new CountDownLatch(1);
    executor.execute(run::countDown);
    executor.close();
    assertThat(run.await(PATIENCE_SECONDS, TimeUnit.SECONDS)).isTrue();
  }

  @Test
  void aLeaseExpiresThoughNoThreadCouldBeStartedWhenItsTimeWasUp() throws Exception {
    missing.set(1);
    CountDownLatch over = new CountDownLatch(1);
    try (StallProbe probe = StallProbe.start();
        LeaseRegistry book =
            new LeaseRegistry(
                "atrv1/gps",
                LeaseTerms.DEFAULT,
                InstantSource.fixed(Instant.EPOCH),
                Scheduler.system(),
                clients -> {},
                holder -> executor)) {
      StallProbe.Stopwatch begun = probe.stopwatch();
      book.grant(Duration.ofMillis(10), LeaseRole.CLIENT, null, over::countDown);
      assertThat(over.await(PATIENCE_SECONDS, TimeUnit.SECONDS)).isTrue();
      begun.stop().requireWithin("the end of the lease", Duration.ofMillis(1010));
      assertThat(book.leases()).isEmpty();
    }
  }

  @Test
  void nobodyWaitsForATaskLongerThanItMayTake() {
    CountDownLatch release = new CountDownLatch(1);
    Runnable heldUp =
        () -> {
          try {
            release.await();
          } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
          }
          done.add("held up");
        };
    Duration patience = Duration.ofMillis(100);
    assertThat(executor.executeWithin(heldUp, patience)).isFalse();
    assertThat(executor.executeWithin(() -> done.add("next"), patience)).isFalse();
    assertThat(done).isEmpty();
    release.countDown();
    assertThat(executor.executeWithin(() -> done.add("last"), Duration.ofSeconds(20))).isTrue();
    assertThat(done).containsExactly("held up", "next", "last");
  }

  @Test
  void whatATaskThrowsReachesTheThreadThatWaitsForIt() {
    Runnable faulty =
        () -> {
          throw new IllegalStateException("no such wire");
        };
    assertThatThrownBy(() -> executor.executeWithin(faulty, Duration.ofSeconds(20)))
        .isInstanceOf(IllegalStateException.class)
        .hasMessage("no such wire");
    assertThat(executor.executeWithin(() -> done.add("goes on"), Duration.ofSeconds(20))).isTrue();
  }
}
