package org.dfra.event.delivery;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import java.rmi.RemoteException;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Queue;
import java.util.Set;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.IntStream;
import org.dfra.event.Delivery;
import org.dfra.event.DeliveryPolicy;
import org.dfra.event.ModuleEvent;
import org.dfra.event.Reading;
import org.dfra.flow.sensor.CameraImage;
import org.dfra.flow.sensor.RangeScan;
import org.dfra.time.Scheduler;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;

/** Which events one call delivers; steps by hand, without threads. */
class ListenerQueueTest {

  private static final Duration SLOW = Duration.ofMillis(250);
  private static final int FAILURES = 3;

  private record Tick(Instant measured) implements Reading {}

  /** A reading of which nobody knows how large it is. */
  private record Bag(Instant measured, Set<String> things) implements Reading {}

  /** Tasks wait here until the test runs them. */
  private static final class Steps implements Scheduler {
    long now = Long.MAX_VALUE - 10; // overflows soon

    @Override
    public long nanos() {
      return now;
    }

    @Override
    public ScheduledTask after(long nanos, Runnable task) {
      throw new IllegalStateException("a queue without a rate needs no timer");
    }
  }

  private final Steps time = new Steps();
  private final Queue<Runnable> pool = new ArrayDeque<>();
  private final List<List<Long>> calls = new ArrayList<>();
  private final List<Delivery> delivered = new ArrayList<>();
  private final AtomicInteger givenUp = new AtomicInteger();
  private @Nullable RemoteException failure;
  private Duration taking = Duration.ZERO;
  private long published;

  private ListenerQueue queue(int events, long bytes, DeliveryPolicy policy) {
    return new ListenerQueue(
        this::call,
        new BatchLimits(events, bytes, SLOW),
        policy,
        FAILURES,
        givenUp::incrementAndGet,
        pool::add,
        time);
  }

  private void call(List<Delivery> deliveries) throws RemoteException {
    calls.add(deliveries.stream().map(Delivery::sequence).toList());
    time.now += taking.toNanos();
    if (failure != null) {
      throw failure;
    }
    delivered.addAll(deliveries);
  }

  private void publish(ListenerQueue queue, int count) {
    for (int i = 0; i < count; i++) {
      publish(queue, new Tick(Instant.EPOCH));
    }
  }

  private void publish(ListenerQueue queue, Reading reading) {
    queue.offer(
        new Delivery("r/m", 1, ++published, 0, Instant.EPOCH, new ModuleEvent.NewReading(reading)));
  }

  /** Makes the calls that are due, at most so many. */
  private void run(int most) {
    for (int i = 0; i < most && !pool.isEmpty(); i++) {
      pool.remove().run();
    }
  }

  private static List<Long> numbers(int first, int last) {
    return IntStream.rangeClosed(first, last).asLongStream().boxed().toList();
  }

  @Test
  void oneCallDeliversWhatWaits() {
    ListenerQueue queue = queue(64, 1 << 20, DeliveryPolicy.keepLast(100));
    publish(queue, 1);
    publish(queue, 19);
    assertThat(pool).as("one call at a time").hasSize(1);
    run(1);
    assertThat(calls).containsExactly(numbers(1, 20));
    assertThat(pool).isEmpty();
    publish(queue, 1);
    run(1);
    assertThat(calls).containsExactly(numbers(1, 20), numbers(21, 21));
  }

  @Test
  void aCallHasOnlySoManyEventsAndTheOrderStays() {
    ListenerQueue queue = queue(8, 1 << 20, DeliveryPolicy.keepLast(100));
    publish(queue, 20);
    run(10);
    assertThat(calls).containsExactly(numbers(1, 8), numbers(9, 16), numbers(17, 20));
  }

  @Test
  void aCallHasOnlySoManyBytesButOneEventAlways() {
    ListenerQueue queue = queue(64, 4_000, DeliveryPolicy.keepLast(100));
    publish(queue, 1);
    publish(queue, scan());
    publish(queue, 2);
    publish(queue, image(100_000));
    publish(queue, 1);
    run(10);
    assertThat(calls)
        .as("a scan of 361 beams is within the bytes of one call, an image is in none")
        .containsExactly(numbers(1, 4), numbers(5, 5), numbers(6, 6));
  }

  @Test
  void anEventOfUnknownSizeIsDeliveredAlone() {
    ListenerQueue queue = queue(64, 1 << 20, DeliveryPolicy.keepLast(100));
    publish(queue, 2);
    publish(queue, new Bag(Instant.EPOCH, new HashSet<>(Set.of("a"))));
    publish(queue, 2);
    run(10);
    assertThat(calls).containsExactly(numbers(1, 2), numbers(3, 3), numbers(4, 5));
  }

  private static RangeScan scan() {
    return new RangeScan(Instant.EPOCH, "r/laser", 0, 0.01, 0, 0, 80, new float[361]);
  }

  private static CameraImage image(int bytes) {
    return new CameraImage(
        Instant.EPOCH,
        "r/camera",
        CameraImage.Band.VISIBLE,
        320,
        240,
        300,
        "image/jpeg",
        new byte[bytes]);
  }

  /** The remaining time of a deadline would not suffice for many. */
  @Test
  void aSlowCallIsFollowedByShorterOnesAndFastOnesByLonger() {
    ListenerQueue queue = queue(16, 1 << 20, DeliveryPolicy.keepLast(1000));
    publish(queue, 100);
    taking = SLOW.plusNanos(1);
    run(3);
    taking = SLOW;
    run(4);
    assertThat(calls.stream().map(List::size)).containsExactly(16, 8, 4, 2, 4, 8, 16);
    assertThat(delivered.stream().map(Delivery::sequence)).isEqualTo(numbers(1, 58));
  }

  @Test
  void aFailedCallDropsAllItsEventsCountsOnceAndIsFollowedByAShortOne() {
    ListenerQueue queue = queue(16, 1 << 20, DeliveryPolicy.keepLast(10));
    publish(queue, 12); // two more than are kept
    failure = new RemoteException("no way there");
    run(1);
    failure = null;
    publish(queue, 3);
    run(10);
    assertThat(calls).containsExactly(numbers(3, 12), numbers(13, 13), numbers(14, 15));
    assertThat(delivered.get(0).dropped()).as("2 by the policy, 10 of the call").isEqualTo(12);
    assertThat(delivered.get(1).dropped()).isZero();
    assertThat(givenUp).hasValue(0);
  }

  @Test
  void threeFailedCallsInARowAreTheEndWhateverTheyContain() {
    ListenerQueue queue = queue(16, 1 << 20, DeliveryPolicy.keepLast(100));
    publish(queue, 30);
    failure = new RemoteException("no way there");
    run(10);
    assertThat(calls).containsExactly(numbers(1, 16), numbers(17, 17), numbers(18, 18));
    assertThat(givenUp).hasValue(1);
    assertThat(queue.isOpen()).isFalse();
  }

  @Test
  void aLimitedRateIsThatOfEvents() {
    List<Runnable> later = new ArrayList<>();
    Scheduler timer =
        new Scheduler() {
          @Override
          public long nanos() {
            return 0;
          }

          @Override
          public ScheduledTask after(long nanos, Runnable task) {
            later.add(task);
            return () -> {};
          }
        };
    ListenerQueue queue =
        new ListenerQueue(
            this::call,
            new BatchLimits(64, 1 << 20, SLOW),
            DeliveryPolicy.keepLast(10).withMaxRate(5),
            FAILURES,
            () -> {},
            pool::add,
            timer);
    publish(queue, 3);
    run(10);
    assertThat(calls).containsExactly(numbers(1, 1));
    assertThat(later).as("the next waits for its time").hasSize(1);
    later.remove(0).run();
    run(10);
    assertThat(calls).containsExactly(numbers(1, 1), numbers(2, 2));
  }

  @Test
  void aClosedQueueDeliversNothingMore() {
    ListenerQueue queue = queue(16, 1 << 20, DeliveryPolicy.keepLast(100));
    publish(queue, 5);
    queue.close();
    run(10);
    assertThat(calls).isEmpty();
  }

  @Test
  void limitsAreAboveZero() {
    assertThatIllegalArgumentException()
        .isThrownBy(() -> new BatchLimits(0, 1, SLOW))
        .withMessage(
            "limits of a batch must be above 0, and these are 0 events, 1 bytes and PT0.25S");
  }
}
