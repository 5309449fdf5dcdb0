package org.dfra.experiments.recruit.embedded;

import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ConcurrentLinkedQueue;
import org.dfra.recruit.message.MessageEnvelope;
import org.jspecify.annotations.Nullable;

/**
 * Message delays in real time, and the lateness of timers. A message's delay starts with the event
 * that causes it, a call, a message or a timer, and ends when its receiver has it: so it includes
 * the agents' computing time, which is zero in the simulation. Thread-safe.
 */
public final class MessageDelays {

  private record Sent(String from, long number, String to) {}

  /** When the thread's current event began, by {@link System#nanoTime}. */
  private static final ThreadLocal<@Nullable Long> BEGAN = new ThreadLocal<>();

  /** Runs an agent's reaction to an event. Nested reactions belong to the same event. */
  static void runTimed(Runnable turn) {
    if (BEGAN.get() != null) {
      turn.run();
      return;
    }
    BEGAN.set(System.nanoTime());
    try {
      turn.run();
    } finally {
      BEGAN.remove();
    }
  }

  /** The delays in one network: robot names are unique in it only. */
  final class NetworkDelays {

    private final Map<Sent, Long> underWay = new ConcurrentHashMap<>();

    void sent(String to, MessageEnvelope envelope) {
      Long began = BEGAN.get();
      underWay.put(
          new Sent(envelope.sender(), envelope.number(), to),
          began == null ? System.nanoTime() : began);
    }

    void came(String to, MessageEnvelope envelope) {
      Long at = underWay.remove(new Sent(envelope.sender(), envelope.number(), to));
      if (at != null) { // otherwise it was a duplicate
        delays.add((System.nanoTime() - at) / 1e9);
      }
    }
  }

  private final ConcurrentLinkedQueue<Double> delays = new ConcurrentLinkedQueue<>();

  private final ConcurrentLinkedQueue<Double> late = new ConcurrentLinkedQueue<>();

  NetworkDelays newNetwork() {
    return new NetworkDelays();
  }

  /** Adds a timer's lateness, seconds. */
  void addTimerDelay(double seconds) {
    late.add(seconds);
  }

  /** Delays of all messages so far, seconds. */
  public double[] messageDelays() {
    return delays.stream().mapToDouble(Double::doubleValue).toArray();
  }

  /** Lateness of all timers so far, seconds. */
  public double[] timerDelays() {
    return late.stream().mapToDouble(Double::doubleValue).toArray();
  }
}
