package org.dfra.experiments.recruit;

import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.function.Function;
import org.dfra.cli.log.LogbackLevels;
import org.dfra.experiments.recruit.embedded.EmbeddedRuns;
import org.dfra.experiments.recruit.embedded.MessageDelays;
import org.dfra.experiments.recruit.simulation.Experiment;
import org.dfra.experiments.recruit.simulation.ExperimentGrid.CellResult;
import org.dfra.experiments.recruit.simulation.ExperimentGrid.ExperimentCell;
import org.dfra.experiments.recruit.simulation.ExperimentPlan;
import org.dfra.experiments.recruit.simulation.MeasuredDelays;
import org.dfra.experiments.recruit.simulation.Seeds;
import org.dfra.module.LogLevel;
import org.dfra.report.measurement.MeasuredValue;
import org.dfra.report.progress.ProgressReporter;

/** Runs a part of the experiment over real JERI, and the same over the simulated network. */
final class EmbeddedExperiment {

  private static final int OTHERS = 10; // runs with other seeds, for each real one
  private static final String DELAYS = "message-delays.csv";
  private static final String TIMERS = "timer-delays.csv";

  private final ExperimentPlan plan;
  private final int seeds;
  private final int jobs;
  private final double speed;
  private final ProgressReporter progress;

  /**
   * @param jobs number of parallel real runs
   * @param speed seconds of the agents' time per real second
   */
  EmbeddedExperiment(
      ExperimentPlan plan, int seeds, int jobs, double speed, ProgressReporter progress) {
    this.plan = EmbeddedRuns.shorter(plan);
    this.seeds = seeds;
    this.jobs = jobs;
    this.speed = speed;
    this.progress = progress;
  }

  /**
   * Runs all and writes the report into the folder.
   *
   * @return the file to open
   */
  Path run(Path folder) throws IOException, InterruptedException {
    LogbackLevels levels = new LogbackLevels(); // agents' logs are not of interest here
    levels.set("dfra", LogLevel.ERROR);
    levels.set("com.sun.jini", LogLevel.ERROR);
    levels.set("org.dfra.river", LogLevel.ERROR); // delays show that the machine was slow
    List<ExperimentCell> cells = EmbeddedRuns.cells();
    this.progress.section("running", "Recruitment strategies compared over remote events");
    this.progress.say(
        "%d cells with %d seeds each are %d runs of %d calls over JERI; %d run at once, %.0f"
            + " times as fast as real time.",
        cells.size(), seeds, cells.size() * seeds, plan.calls(), jobs, speed);
    ProgressReporter.Stopwatch watch = this.progress.stopwatch();
    try (EmbeddedRuns runs = new EmbeddedRuns(plan, jobs, speed)) {
      this.progress.say(
          "Some runs come first that are not evaluated, so that the JVM compiles the code.");
      RunProgress progress = new RunProgress(this.progress, System::nanoTime);
      List<CellResult> real =
          runs.run(
              cells,
              Seeds.evaluation(seeds),
              (done, all) -> { // runs that start together end together
                if (done >= jobs) {
                  progress.done(done, all);
                }
              });
      double load = ManagementFactory.getOperatingSystemMXBean().getSystemLoadAverage();
      double took = watch.elapsed().toNanos() / 1e9;
      this.progress.say(
          "All runs over JERI have finished after %.1f s; the computer's load is %.1f.",
          took, load);
      double[] envelopes =
          keep(folder.resolve(DELAYS), cells, cell -> runs.delays(cell).messageDelays());
      double[] timers =
          keep(folder.resolve(TIMERS), cells, cell -> runs.delays(cell).timerDelays());
      TransportComparisonReport report =
          new TransportComparisonReport(compare(cells, real, runs), how(envelopes, timers, load));
      Path file = report.write(folder);
      this.progress.say("%s", report.summary());
      for (MeasuredValue each : report.figures().all()) {
        this.progress.figure(each.name(), each.value(), each.target(), each.unit());
      }
      return file;
    }
  }

  /** The same cells, each with the delays of its real runs, in the agents' time. */
  private List<TransportComparison> compare(
      List<ExperimentCell> cells, List<CellResult> real, EmbeddedRuns runs)
      throws InterruptedException {
    List<CellResult> paired = new ArrayList<>();
    List<CellResult> others = new ArrayList<>();
    for (ExperimentCell cell : cells) {
      MessageDelays times = runs.delays(cell);
      Experiment simulation =
          new Experiment(
              plan.with(scaled(times.messageDelays()), scaled(times.timerDelays())),
              Runtime.getRuntime().availableProcessors());
      paired.addAll(simulation.run(List.of(cell), Seeds.evaluation(seeds), (done, all) -> {}));
      others.addAll(
          simulation.run(List.of(cell), Seeds.replication(OTHERS * seeds), (done, all) -> {}));
    }
    return TransportComparison.all(real, paired, others);
  }

  private MeasuredDelays scaled(double[] seconds) {
    return new MeasuredDelays(Arrays.stream(seconds).map(each -> each * speed).toArray());
  }

  /**
   * Writes the delays of each cell, milliseconds of real time, and returns those of all cells,
   * seconds.
   */
  private static double[] keep(
      Path file, List<ExperimentCell> cells, Function<ExperimentCell, double[]> times)
      throws IOException {
    StringBuilder lines = new StringBuilder("strategy,mode,vehicles,loss,delay_ms\n");
    List<double[]> all = new ArrayList<>();
    for (ExperimentCell cell : cells) {
      double[] seconds = times.apply(cell);
      all.add(seconds);
      for (double each : seconds) {
        lines.append(
            String.format(
                Locale.ROOT,
                "%s,%s,%d,%.2f,%.4f%n",
                cell.strategy(),
                StrategyComparisonReport.name(cell.mode()),
                cell.vehicles(),
                cell.loss(),
                1e3 * each));
      }
    }
    Files.writeString(file, lines);
    return all.stream().flatMapToDouble(Arrays::stream).toArray();
  }

  private String how(double[] envelopes, double[] timers, double load) {
    MeasuredDelays way = new MeasuredDelays(envelopes);
    MeasuredDelays late = new MeasuredDelays(timers);
    return String.format(
        Locale.ROOT,
        "Real: agents exported by JERI find each other in a lookup service by the percepts that"
            + " they observe, and exchange remote events over the loopback interface of one JVM."
            + " Their sender drops messages by seeded random numbers, robots move as in the"
            + " simulation, and time passes %.0f times as fast as real time, so the computer's"
            + " delays count %.0f times. Each cell has %d runs, %d run at once; the load of the"
            + " computer was %.1f. Of %d messages, the median delay was %.2f ms, the 90th"
            + " percentile %.2f ms and the 99th %.2f ms; timers were late by %.2f ms, %.2f ms and"
            + " %.2f ms, all in real time. Simulated: the same agents and places; delays of"
            + " messages and timers are drawn independently from those of that cell, times %.0f.",
        speed,
        speed,
        seeds,
        jobs,
        load,
        envelopes.length,
        1e3 * way.quantile(0.5),
        1e3 * way.quantile(0.9),
        1e3 * way.quantile(0.99),
        1e3 * late.quantile(0.5),
        1e3 * late.quantile(0.9),
        1e3 * late.quantile(0.99),
        speed);
  }
}
