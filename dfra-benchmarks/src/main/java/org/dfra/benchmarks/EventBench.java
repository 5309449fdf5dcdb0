package org.dfra.benchmarks;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import java.util.stream.DoubleStream;
import org.dfra.benchmarks.event.BenchSensor;
import org.dfra.cli.log.LogbackLevels;
import org.dfra.event.delivery.ListenerQueue;
import org.dfra.module.LogLevel;
import org.dfra.river.server.sensor.GPSServer;

/**
 * Measures the latency of an event from the publishing sensor to each of twenty listeners in
 * separate processes, and whether one suspended listener delays the other nineteen. Rounds with and
 * without the suspended listener alternate, so that noise affects both equally.
 */
final class EventBench implements Bench {

  /** Events per second. */
  static final int RATE = BenchSensor.RATE;

  private static final long PERIOD = TimeUnit.SECONDS.toNanos(1) / RATE;
  private static final int LISTENERS = 20;
  private static final int PAIRS = 6;

  /**
   * Enough events for the JIT compiler to reach the steady state that a robot's JVM reaches within
   * minutes; published faster, so that the warm-up does not take minutes.
   */
  private static final int WARM_UP = 1500;

  private static final long WARM_UP_PERIOD = PERIOD / 5;

  /** Shorter than the six seconds without response after which a listener is dropped. */
  private static final int ROUND = 5 * RATE;

  /** The first events of a round are not counted: the previous round may not be over. */
  private static final int SETTLING = RATE;

  private static final double NANOS_PER_MILLI = 1e6;
  private static final long LEASE = 30_000;

  private final long[] published = new long[WARM_UP + 2 * PAIRS * ROUND + 1]; // by number, from 1
  private int last;

  @Override
  public void run(Report report) throws Exception {
    // The suspended listener cannot receive: this is expected and not an error.
    new LogbackLevels().set(ListenerQueue.class.getName(), LogLevel.ERROR);
    report.say("Starting " + LISTENERS + " processes that listen …");
    List<ListenerProcess> listeners = new ArrayList<>();
    try (BenchRegistrar reggie = new BenchRegistrar(LEASE);
        GPSServer server = BenchSensor.serve(List.of(reggie.locator()))) {
      try {
        report.say(server.identification().path() + " is up.");
        for (int i = 0; i < LISTENERS; i++) {
          listeners.add(new ListenerProcess(reggie.locator()));
        }
        for (ListenerProcess each : listeners) {
          each.awaitReady();
        }
        for (ListenerProcess each : listeners) {
          each.checkClock();
        }
        report.say(
            "Telling them "
                + RATE
                + " events per second for "
                + (2 * PAIRS * ROUND / RATE)
                + " s; every other "
                + (ROUND / RATE)
                + " s one of them is stopped …");
        measure(BenchSensor.awaitInstance(), listeners.get(0));
        report(report, listeners);
      } finally {
        for (ListenerProcess each : listeners) {
          each.close();
        }
      }
    }
  }

  private void measure(BenchSensor sensor, ListenerProcess victim)
      throws IOException, InterruptedException {
    publish(sensor, WARM_UP, WARM_UP_PERIOD);
    for (int pair = 0; pair < PAIRS; pair++) {
      publish(sensor, ROUND, PERIOD);
      victim.signal("STOP");
      try {
        publish(sensor, ROUND, PERIOD);
      } finally {
        victim.signal("CONT");
      }
    }
  }

  /** Publishes this many events at a steady rate; returns one period after the last. */
  private void publish(BenchSensor sensor, int events, long period) {
    long next = System.nanoTime();
    for (int i = 0; i < events; i++) {
      last++;
      published[last] = System.nanoTime();
      sensor.publish();
      next += period;
      for (long wait; (wait = next - System.nanoTime()) > 0; ) {
        LockSupport.parkNanos(this, wait);
      }
    }
  }

  private void report(Report report, List<ListenerProcess> listeners) throws IOException {
    List<Map<Long, Long>> reported = new ArrayList<>();
    for (ListenerProcess each : listeners) {
      reported.add(each.report());
    }
    List<Map<Long, Long>> healthy = reported.subList(1, reported.size());
    double[][] beside = new double[PAIRS][];
    double[][] besideStopped = new double[PAIRS][];
    double[][] all = new double[PAIRS][];
    for (int pair = 0; pair < PAIRS; pair++) {
      int first = WARM_UP + 2 * pair * ROUND + 1;
      all[pair] = latencies(reported, first);
      beside[pair] = latencies(healthy, first);
      besideStopped[pair] = latencies(healthy, first + ROUND);
    }
    String events = "event latency, " + RATE + " Hz, " + LISTENERS + " listening processes, ";
    report.figure(events + "median", quantile(all, 0.5), "ms");
    report.figure(events + "p99", quantile(all, 0.99), 5, "ms");
    report.figure(events + "longest", quantile(all, 1), "ms");
    for (double part : new double[] {0.5, 0.99}) {
      String what = (part == 0.5 ? "median" : "p99") + " of 19 beside ";
      report.figure(what + "a running one", quantile(beside, part), "ms");
      report.figure(what + "a stopped one", quantile(besideStopped, part), 5, "ms");
    }
    double[] added = new double[PAIRS];
    for (int pair = 0; pair < PAIRS; pair++) {
      added[pair] = Report.quantile(besideStopped[pair], 0.5) - Report.quantile(beside[pair], 0.5);
    }
    report.figure(
        "added by the stopped one: median of " + PAIRS + " paired differences of medians",
        Report.quantile(added, 0.5),
        0.25,
        "ms");
  }

  /** Of a round's events, from the sensor to these listeners, each in milliseconds. */
  private double[] latencies(List<Map<Long, Long>> reported, int first) throws IOException {
    double[] latencies = new double[(ROUND - SETTLING) * reported.size()];
    int count = 0;
    for (int number = first + SETTLING; number < first + ROUND; number++) {
      for (Map<Long, Long> each : reported) {
        Long at = each.get((long) number);
        if (at == null) {
          throw new IOException("a listener did not receive event " + number + " of " + last);
        }
        latencies[count++] = (at - published[number]) / NANOS_PER_MILLI;
      }
    }
    return latencies;
  }

  private static double quantile(double[][] rounds, double part) {
    return Report.quantile(Arrays.stream(rounds).flatMapToDouble(DoubleStream::of).toArray(), part);
  }
}
