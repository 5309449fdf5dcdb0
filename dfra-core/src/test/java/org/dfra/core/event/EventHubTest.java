package org.dfra.core.event;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.awaitility.Awaitility.await;

import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Set;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicLongArray;
import java.util.concurrent.locks.LockSupport;
import org.dfra.core.state.StateStore;
import org.dfra.event.Delivery;
import org.dfra.event.DeliveryPolicy;
import org.dfra.event.DeliveryPolicy.EventKind;
import org.dfra.event.ModuleEvent;
import org.dfra.event.ModuleListener;
import org.dfra.event.Reading;
import org.dfra.event.delivery.DeliveryCounter;
import org.dfra.event.delivery.DeliveryPool;
import org.dfra.event.delivery.ListenerQueue;
import org.dfra.time.Scheduler;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

@Timeout(60)
class EventHubTest {

  private static final Duration PATIENCE = Duration.ofSeconds(30);

  private record Tick(Instant measured) implements Reading {}

  private static final ModuleEvent TICK = new ModuleEvent.NewReading(new Tick(Instant.EPOCH));
  private static final int EVENTS = 100;
  private static final int HEALTHY = 19;

  private final DeliveryPool pool = new DeliveryPool(2, Scheduler.system());
  private final EventHub hub = hub(StateStore.inMemory());

  private EventHub hub(StateStore state) {
    return new EventHub("atrv1/lamp", InstantSource.system(), state, pool, Scheduler.system());
  }

  private EventHub.ListenerEntry add(ModuleListener listener, DeliveryPolicy policy) {
    return hub.add(listener, policy, ListenerQueue.NEVER_GIVE_UP, () -> {});
  }

  /**
   * The stopped listener is not let go before every healthy one has every event, so none of them
   * can have waited for it. What it costs in time is printed, not asserted: a busy machine adds
   * more.
   */
  @Test
  void aStoppedListenerHoldsUpNoneOfNineteenHealthyOnes() {
    long[] without = latencies();
    CountDownLatch stopped = new CountDownLatch(1);
    EventHub.ListenerEntry blocked =
        add(
            delivery -> {
              try {
                stopped.await();
              } catch (InterruptedException e) {
                Thread.currentThread().interrupt();
              }
            },
            DeliveryPolicy.keepLast(8));
    long[] with = latencies();
    int threads = pool.threadCount();
    // One that the computer held up counted as blocked too; it goes while events come.
    for (int i = 0; i < HEALTHY; i++) {
      add(delivery -> {}, DeliveryPolicy.latestReading());
    }
    await("two, and one for the stopped")
        .atMost(PATIENCE)
        .until(
            () -> {
              hub.publish(TICK);
              return pool.threadCount() <= 3;
            });
    stopped.countDown();
    hub.remove(blocked);
    System.out.printf(
        "latency of %d listeners, median and 99th of 100, in ms: %.3f %.3f; with one stopped %.3f"
            + " %.3f; threads %d%n",
        HEALTHY, at(without, 0.5), at(without, 0.99), at(with, 0.5), at(with, 0.99), threads);
    assertThat(with).as("every event at every healthy listener").hasSize(EVENTS * HEALTHY);
  }

  private static double at(long[] sorted, double share) {
    return sorted[(int) (share * (sorted.length - 1))] / 1e6;
  }

  /** Nanoseconds from publishing to each healthy listener, sorted. */
  private long[] latencies() {
    AtomicLongArray published = new AtomicLongArray(EVENTS);
    AtomicLongArray took = new AtomicLongArray(EVENTS * HEALTHY);
    AtomicInteger done = new AtomicInteger();
    List<EventHub.ListenerEntry> entries = new ArrayList<>();
    for (int i = 0; i < HEALTHY; i++) {
      int listener = i;
      int[] next = {0};
      entries.add(
          add(
              delivery -> {
                int event = next[0]++;
                took.set(event * HEALTHY + listener, System.nanoTime() - published.get(event));
                done.incrementAndGet();
              },
              DeliveryPolicy.keepLast(EVENTS)));
    }
    long begin = System.nanoTime();
    for (int event = 0; event < EVENTS; event++) {
      long due = begin + event * 10_000_000L;
      while (System.nanoTime() - due < 0) {
        LockSupport.parkNanos(due - System.nanoTime()); // the sensor's rate
      }
      published.set(event, System.nanoTime());
      hub.publish(TICK);
    }
    await().atMost(PATIENCE).until(() -> done.get() == EVENTS * HEALTHY);
    entries.forEach(hub::remove);
    long[] sorted = new long[EVENTS * HEALTHY];
    Arrays.setAll(sorted, took::get);
    Arrays.sort(sorted);
    return sorted;
  }

  @Test
  void givesUpAListenerThatFailsAgainAndAgain() {
    AtomicInteger given = new AtomicInteger();
    AtomicInteger asked = new AtomicInteger();
    hub.add(
        delivery -> {
          asked.incrementAndGet();
          throw new java.rmi.ConnectException("no such peer");
        },
        DeliveryPolicy.keepLast(10),
        3,
        given::incrementAndGet);
    for (int i = 0; i < 10; i++) {
      hub.publish(TICK);
    }
    await().atMost(PATIENCE).until(() -> given.get() == 1);
    assertThat(asked).hasValue(3);
    assertThat(hub.entries()).isEmpty();
  }

  @Test
  void publishingNeverWaitsForAListener() {
    CountDownLatch stopped = new CountDownLatch(1);
    for (int i = 0; i < 10; i++) {
      add(
          delivery -> {
            try {
              stopped.await();
            } catch (InterruptedException e) {
              Thread.currentThread().interrupt();
            }
          },
          DeliveryPolicy.latestReading());
    }
    for (int i = 0; i < 10_000; i++) {
      hub.publish(TICK); // would not return if it waited
    }
    await().atMost(PATIENCE).until(() -> pool.threadCount() >= 10);
    assertThat(pool.threadCount()).as("two, and one for each blocked").isLessThanOrEqualTo(12);
    stopped.countDown();
    await().atMost(PATIENCE).until(() -> pool.threadCount() <= 2);
  }

  @Test
  void numbersGoOnInTheNextLifeAndTheEpochGrows() {
    StateStore state = StateStore.inMemory();
    hub(state).publish(TICK);
    hub(state).publish(new ModuleEvent.ParameterChanged("rate", "1"));
    EventHub third = hub(state);
    EventHub.ListenerEntry entry =
        third.add(
            delivery -> {}, DeliveryPolicy.keepLast(1), ListenerQueue.NEVER_GIVE_UP, () -> {});
    assertThat(entry.epoch()).isEqualTo(3);
    assertThat(entry.lastSequences()[EventKind.READING.ordinal()]).isEqualTo(1);
    assertThat(entry.lastSequences()[EventKind.PARAMETER.ordinal()]).isEqualTo(1);
    assertThat(entry.lastSequences()[EventKind.INCIDENT.ordinal()]).isZero();
  }

  @Test
  void aTallyCountsGapsLeavesOutWhatCameBeforeAndForgivesALossOfPower() throws Exception {
    List<Long> passed = new ArrayList<>();
    DeliveryCounter counter = new DeliveryCounter(delivery -> passed.add(delivery.sequence()));
    counter.startAfter(new long[] {0, 10, 0, 0});
    for (long sequence : new long[] {12, 12, 11, 15}) {
      counter.notify(reading(1, sequence));
    }
    counter.notify(reading(2, 16));
    counter.notify(reading(3, 4)); // the numbers fell back
    counter.notify(reading(3, 5));
    assertThat(passed).containsExactly(12L, 15L, 16L, 4L, 5L);
    assertThat(counter.received()).isEqualTo(5);
    assertThat(counter.lost()).isEqualTo(3);
  }

  private static Delivery reading(long epoch, long sequence) {
    return new Delivery("atrv1/lamp", epoch, sequence, 0, Instant.EPOCH, TICK);
  }

  @Test
  void refusesPoliciesThatCannotBeKept() {
    assertThatThrownBy(() -> DeliveryPolicy.keepLast(0)).hasMessage("depth 0 is outside 1 to 1024");
    assertThatThrownBy(() -> DeliveryPolicy.latestReading().withMaxRate(0))
        .hasMessage("rate 0.0 Hz is not above 0");
    assertThatThrownBy(() -> new DeliveryPolicy(Set.of(), 1, 1))
        .hasMessage("no kinds of events are given; give one or more, or add no listener");
  }
}
