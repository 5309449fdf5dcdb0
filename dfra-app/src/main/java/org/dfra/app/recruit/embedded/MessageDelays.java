package org.dfra.app.recruit.embedded;

import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ConcurrentLinkedQueue;
import org.dfra.recruit.message.MessageEnvelope;
import org.jspecify.annotations.Nullable;

/**
 * For how long letters were on their way, in real time, and how late timers were. A letter is on
 * its way from when its sender has reason to write it, a call, a letter or a timer, until its
 * receiver has it: so what agents compute, which takes no time in the simulation, counts as well.
 * Safe for use by several threads.
 */
public final class MessageDelays {

  private record Sent(String from, long number, String to) {}

  /** When what its thread does began, by {@link System#nanoTime}. */
  private static final ThreadLocal<@Nullable Long> BEGAN = new ThreadLocal<>();

  /** Does what an agent has reason to do. What is done within it has the same reason. */
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

  /** By one network: robots have the same names in others. */
  final class NetworkDelays {

    private final Map<Sent, Long> underWay = new ConcurrentHashMap<>();

    void sent(String to, MessageEnvelope letter) {
      Long began = BEGAN.get();
      underWay.put(
          new Sent(letter.sender(), letter.number(), to),
          began == null ? System.nanoTime() : began);
    }

    void came(String to, MessageEnvelope letter) {
      Long at = underWay.remove(new Sent(letter.sender(), letter.number(), to));
      if (at != null) { // else it came twice
        delays.add((System.nanoTime() - at) / 1e9);
      }
    }
  }

  private final ConcurrentLinkedQueue<Double> delays = new ConcurrentLinkedQueue<>();

  private final ConcurrentLinkedQueue<Double> late = new ConcurrentLinkedQueue<>();

  NetworkDelays newNetwork() {
    return new NetworkDelays();
  }

  /** That a timer was late by so many seconds. */
  void addTimerDelay(double seconds) {
    late.add(seconds);
  }

  /** Of all letters so far, seconds. */
  public double[] messageDelays() {
    return delays.stream().mapToDouble(Double::doubleValue).toArray();
  }

  /** Of all timers so far, seconds. */
  public double[] timerDelays() {
    return late.stream().mapToDouble(Double::doubleValue).toArray();
  }
}
