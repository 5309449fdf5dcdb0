package org.dfra.benchmarks;

import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import org.apache.commons.statistics.distribution.LogNormalDistribution;
import org.apache.commons.statistics.inference.KolmogorovSmirnovTest;
import org.dfra.benchmarks.event.BenchSensor;
import org.dfra.cli.log.LogbackLevels;
import org.dfra.event.delivery.ListenerQueue;
import org.dfra.experiments.recruit.simulation.MessageRate;
import org.dfra.module.LogLevel;
import org.dfra.recruit.river.RecruitmentAgentServer;
import org.dfra.recruit.transport.DelayModel.LogNormalDelay;
import org.dfra.river.server.sensor.GPSServer;

/**
 * Measures the number of messages that a hundred agents exchange in one JVM, and the delay of a
 * message and of an event between two processes. The experiment uses the measured message delays
 * directly; the fit error of the best log-normal distribution is reported for comparison.
 */
final class RecruitBench implements Bench {

  private static final int AGENTS = 100;
  private static final int MINUTES = 10; // of the agents' time, per round
  private static final int ROUNDS = 7; // after the same number to warm up
  private static final double MESSAGES = 10_000;

  private static final int WARM_UP = 1000;
  private static final int MEASURED = 2000;

  /** Send period, nanoseconds: threads sleep in between, as between messages. */
  private static final long PERIOD = TimeUnit.MILLISECONDS.toNanos(30);

  private static final long LEASE = 30_000;
  private static final double NANOS_PER_SECOND = 1e9;

  /**
   * @param share share of all values
   * @param deviations number of standard deviations above the mean of a normal distribution
   */
  private record Quantile(double share, double deviations) {}

  private static final List<Quantile> QUANTILES =
      List.of(new Quantile(0.5, 0), new Quantile(0.9, 1.2816), new Quantile(0.99, 2.3263));

  private final Path folder;

  /**
   * @param folder for the delays
   */
  RecruitBench(Path folder) {
    this.folder = folder;
  }

  @Override
  public void run(Report report) throws Exception {
    // The other process exits before the module does: this is expected.
    new LogbackLevels().set(ListenerQueue.class.getName(), LogLevel.ERROR);
    Files.createDirectories(folder);
    rate(report);
    report.say("Another process writes " + MEASURED + " messages to an agent here, and listens …");
    try (BenchRegistrar reggie = new BenchRegistrar(LEASE);
        GPSServer server = BenchSensor.serve(List.of(reggie.locator()));
        RecruitmentAgentServer agent = BenchAgent.serve(reggie.locator());
        ListenerProcess other = new ListenerProcess(reggie.locator())) {
      other.awaitReady();
      other.checkClock();
      report.say(
          agent.identification().path()
              + " is found; the process listens to "
              + server.identification().path()
              + "; the load is "
              + ManagementFactory.getOperatingSystemMXBean().getSystemLoadAverage()
              + ".");
      BenchSensor sensor = BenchSensor.awaitInstance();
      keep(report, "message", messageDelays(BenchAgent.awaitInstance(), other));
      keep(report, "event", events(sensor, other));
    }
  }

  private static void rate(Report report) {
    report.say(AGENTS + " agents in one virtual machine, over the simulated network …");
    double[] seconds = new double[ROUNDS];
    for (int i = 0; i < 2 * ROUNDS; i++) {
      MessageRate.Result result = MessageRate.measure(AGENTS, MINUTES);
      seconds[i % ROUNDS] = MESSAGES / result.rate();
    }
    double median = Report.quantile(seconds, 0.5);
    report.figure("10000 messages among 100 agents, median of " + ROUNDS, median, 1, "s");
    report.figure("messages in a second", MESSAGES / median, "");
  }

  /** Delays from the sender's thread to the agent's thread, seconds; without the response. */
  private static double[] messageDelays(BenchAgent agent, ListenerProcess sender)
      throws IOException {
    double[] delays = new double[MEASURED];
    for (int i = -WARM_UP; i < MEASURED; i++) {
      long[] sent = sender.sendMessage();
      if (i >= 0) {
        delays[i] = (agent.lastReceivedNanos() - sent[0]) / NANOS_PER_SECOND;
        sleep(System.nanoTime() + PERIOD);
      }
    }
    return delays;
  }

  /** Delays from the module to the listener, seconds. */
  private static double[] events(BenchSensor sensor, ListenerProcess listener) throws IOException {
    long[] published = new long[WARM_UP + MEASURED + 1]; // by number, from 1
    long next = System.nanoTime();
    for (int i = 1; i < published.length; i++) {
      published[i] = System.nanoTime();
      sensor.publish();
      next += PERIOD;
      sleep(next);
    }
    Map<Long, Long> reported = listener.report();
    List<Double> delays = new ArrayList<>();
    for (int i = WARM_UP + 1; i < published.length; i++) {
      Long at = reported.get((long) i);
      if (at != null) { // else the queue was full: the machine was busy with other things
        delays.add((at - published[i]) / NANOS_PER_SECOND);
      }
    }
    return delays.stream().mapToDouble(Double::doubleValue).toArray();
  }

  private static void sleep(long until) {
    for (long wait; (wait = until - System.nanoTime()) > 0; ) {
      LockSupport.parkNanos(wait);
    }
  }

  private void keep(Report report, String what, double[] delays) throws IOException {
    StringBuilder lines = new StringBuilder("delay_ms\n");
    for (double each : delays) {
      lines.append(String.format(Locale.ROOT, "%.4f%n", 1e3 * each));
    }
    Path file = folder.resolve("recruit-" + what + "-delays.csv");
    Files.writeString(file, lines);
    LogNormalDelay fit = LogNormalDelay.fit(delays);
    report.figure(what + "s, number measured", delays.length, "");
    for (Quantile each : QUANTILES) {
      String part =
          String.format(Locale.ROOT, "%s, delay, %.0f %% quantile", what, 100 * each.share());
      report.figure(part, 1e3 * Report.quantile(delays, each.share()), "ms");
      report.figure(part + ", fitted", 1e3 * fit.atDeviations(each.deviations()), "ms");
    }
    report.figure(what + ", fit: shortest", 1e3 * fit.shortest(), "ms");
    report.figure(what + ", fit: median above it", 1e3 * fit.median(), "ms");
    report.figure(what + ", fit: sigma", fit.sigma(), "");
    var normal = LogNormalDistribution.of(Math.log(fit.median()), fit.sigma());
    double distance =
        KolmogorovSmirnovTest.withDefaults()
            .statistic(delays, each -> normal.cumulativeProbability(each - fit.shortest()));
    report.figure(what + ", fit: Kolmogorov-Smirnov distance", distance, "");
    report.say("  written to " + file);
  }
}
