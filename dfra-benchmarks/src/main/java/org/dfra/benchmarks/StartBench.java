package org.dfra.benchmarks;

import java.util.ArrayList;
import java.util.Collections;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.function.ToDoubleFunction;
import org.dfra.benchmarks.call.JitSetting;
import org.dfra.benchmarks.start.ComputingTask;
import org.dfra.benchmarks.start.ComputingTask.Work;
import org.dfra.benchmarks.start.RobotStart;
import org.dfra.benchmarks.start.StartCondition;
import org.dfra.examples.harness.DemoEnvironment;
import org.dfra.geometry.GeoPosition;
import org.dfra.river.bootstrap.JvmCommand;
import org.dfra.river.phoenix.host.ClassArchive;

/**
 * Measures how long robots take to start and a group to recover, and how much memory their
 * processes have: without the archive of robots' processes and with it, in turn. Then it compares
 * the JIT compilers for groups that compute. Medians of {@value #ROUNDS} rounds.
 */
final class StartBench implements Bench {

  private static final int ROUNDS = 5;

  private static final double COLD_START = 3.5; // seconds
  private static final double RECOVERY = 0.8; // seconds
  private static final double MEMORY = 50; // megabytes

  private static final List<GeoPosition> ANTENNAS =
      List.of(
          new GeoPosition(27.950603, -82.457200, 14.5),
          new GeoPosition(27.950597, -82.457200, 14.5),
          new GeoPosition(27.950803, -82.457000, 14.5),
          new GeoPosition(27.950797, -82.457000, 14.5));

  @Override
  public void run(Report report) throws Exception {
    boolean hasArchive = JvmCommand.archive().filter(ClassArchive::isUsable).isPresent();
    if (!hasArchive) {
      report.say(
          "There is no archive of robots' processes for this Java, so nothing starts from one; run \"build\" with it.");
    }
    starts(report);
    computing(report);
  }

  private static void starts(Report report) throws Exception {
    Map<StartCondition, List<RobotStart>> all = new EnumMap<>(StartCondition.class);
    try (DemoEnvironment devices = new DemoEnvironment()) {
      List<String> links = devices.startReceivers(ANTENNAS);
      for (int round = 0; round < ROUNDS; round++) {
        List<StartCondition> order = new ArrayList<>(List.of(StartCondition.values()));
        if (round % 2 == 1) {
          Collections.reverse(order);
        }
        for (StartCondition each : order) {
          RobotStart start = RobotStart.measure(each, links);
          all.computeIfAbsent(each, key -> new ArrayList<>()).add(start);
          report.say(
              "Round %d, %s: cold start %.2f s, recovery %.2f s, receiver %.1f MB."
                  .formatted(
                      round + 1,
                      each.label(),
                      start.coldStartSeconds(),
                      start.recoverySeconds(),
                      start.receiverMegabytes()));
        }
      }
      devices.shutDown();
    }
    figures(report, all, "cold start of two robots", RobotStart::coldStartSeconds, COLD_START, "s");
    figures(
        report,
        all,
        "CPU time of the cold start",
        RobotStart::coldStartCpuSeconds,
        Double.POSITIVE_INFINITY,
        "s");
    figures(
        report,
        all,
        "killed group to next call answered",
        RobotStart::recoverySeconds,
        RECOVERY,
        "s");
    figures(
        report,
        all,
        "memory of a receiver's group (PSS)",
        RobotStart::receiverMegabytes,
        MEMORY,
        "MB");
    figures(
        report,
        all,
        "memory of a registrar's group (PSS)",
        RobotStart::registrarMegabytes,
        MEMORY,
        "MB");
    figures(
        report,
        all,
        "memory of phoenix (PSS)",
        RobotStart::phoenixMegabytes,
        Double.POSITIVE_INFINITY,
        "MB");
  }

  private static void figures(
      Report report,
      Map<StartCondition, List<RobotStart>> all,
      String what,
      ToDoubleFunction<RobotStart> value,
      double most,
      String unit) {
    for (StartCondition each : StartCondition.values()) {
      double[] values =
          all.computeIfAbsent(each, key -> new ArrayList<>()).stream().mapToDouble(value).toArray();
      report.figure(
          what + ", " + each.label(),
          Report.quantile(values, 0.5),
          each == StartCondition.AFTER ? most : Double.POSITIVE_INFINITY,
          unit);
    }
  }

  private static void computing(Report report) throws Exception {
    for (Work work : Work.values()) {
      Map<JitSetting, List<ComputingTask.Result>> all = new EnumMap<>(JitSetting.class);
      for (int round = 0; round < ROUNDS; round++) {
        for (JitSetting each : JitSetting.values()) {
          all.computeIfAbsent(each, key -> new ArrayList<>())
              .add(ComputingTask.measure(work, each));
        }
      }
      for (JitSetting each : JitSetting.values()) {
        String what = work.label() + ", " + each.label() + ", ";
        List<ComputingTask.Result> results = all.computeIfAbsent(each, key -> new ArrayList<>());
        figure(report, what + "one step", results, ComputingTask.Result::stepMicros, "µs");
        figure(report, what + "CPU of the start", results, ComputingTask.Result::firstSeconds, "s");
        figure(report, what + "memory (PSS)", results, ComputingTask.Result::megabytes, "MB");
      }
    }
  }

  private static void figure(
      Report report,
      String what,
      List<ComputingTask.Result> results,
      ToDoubleFunction<ComputingTask.Result> value,
      String unit) {
    report.figure(what, Report.quantile(results.stream().mapToDouble(value).toArray(), 0.5), unit);
  }
}
