package org.dfra.event.delivery;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import org.dfra.time.Scheduler;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** Deliveries wait where no thread can or may be started for them; none is lost. */
@Timeout(60)
class DeliveryPoolTest {

  private final AtomicInteger refusals = new AtomicInteger();
  private final DeliveryPool pool =
      new DeliveryPool(
          1,
          3,
          Scheduler.system(),
          thread -> {
            if (refusals.getAndDecrement() > 0) {
              throw new OutOfMemoryError("unable to create native thread");
            }
            thread.start();
          });

  /** A delivery that reports its begin and lasts until it is released. */
  private void block(CountDownLatch blocked, CountDownLatch release) {
    pool.execute(
        () -> {
          blocked.countDown();
          try {
            release.await();
          } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
          }
        });
  }

  @Test
  void aDeliveryIsMadeAsSoonAsAThreadCanBeStarted() throws InterruptedException {
    refusals.set(3);
    CountDownLatch made = new CountDownLatch(1);
    pool.execute(made::countDown);
    assertThat(pool.threadCount()).as("threads, of which none runs").isZero();
    assertThat(made.await(30, TimeUnit.SECONDS)).as("delivered").isTrue();
    assertThat(refusals.get()).as("refusals left").isNegative();
  }

  @Test
  void aListenerIsServedByAnotherThreadOnceOneCanBeStarted() throws InterruptedException {
    CountDownLatch blocked = new CountDownLatch(1);
    CountDownLatch release = new CountDownLatch(1);
    block(blocked, release);
    assertThat(blocked.await(30, TimeUnit.SECONDS)).isTrue();
    refusals.set(2);
    CountDownLatch made = new CountDownLatch(1);
    pool.execute(made::countDown);
    assertThat(made.await(30, TimeUnit.SECONDS)).as("delivered beside the blocked one").isTrue();
    release.countDown();
  }

  @Test
  void deliveriesWaitWhereAsManyThreadsAsMayBeAreBlocked() throws InterruptedException {
    CountDownLatch blocked = new CountDownLatch(3);
    CountDownLatch release = new CountDownLatch(1);
    for (int i = 0; i < 3; i++) {
      block(blocked, release);
    }
    assertThat(blocked.await(30, TimeUnit.SECONDS)).as("three are under way at once").isTrue();
    CountDownLatch made = new CountDownLatch(100);
    for (int i = 0; i < 100; i++) {
      pool.execute(made::countDown);
    }
    assertThat(pool.threadCount()).as("threads while all are blocked").isEqualTo(3);
    assertThat(made.getCount()).as("deliveries that wait").isEqualTo(100);
    release.countDown();
    assertThat(made.await(30, TimeUnit.SECONDS)).as("delivered after the blocked ones").isTrue();
  }
}
