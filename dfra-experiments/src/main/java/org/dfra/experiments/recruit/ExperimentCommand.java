package org.dfra.experiments.recruit;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.concurrent.Callable;
import org.dfra.experiments.recruit.simulation.Experiment;
import org.dfra.experiments.recruit.simulation.ExperimentGrid;
import org.dfra.experiments.recruit.simulation.ExperimentGrid.CellResult;
import org.dfra.experiments.recruit.simulation.ExperimentGrid.ExperimentCell;
import org.dfra.experiments.recruit.simulation.ExperimentPlan;
import org.dfra.experiments.recruit.simulation.MeasuredDelays;
import org.dfra.experiments.recruit.simulation.Seeds;
import org.dfra.recruit.affect.Shame;
import org.dfra.recruit.affect.Shame.ShameSettings;
import org.dfra.recruit.loss.LossModel.GilbertElliottLoss;
import org.dfra.recruit.strategy.RecruitmentStrategy;
import org.dfra.recruit.strategy.StrategyRegistry;
import org.dfra.report.measurement.RecordOption;
import org.dfra.report.plot.Page;
import org.dfra.report.progress.ProgressReporter;
import org.dfra.report.terminal.CommandFailure;
import org.dfra.report.terminal.ExitCode;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;

/** {@code ./dfra recruit experiment}. */
@Command(
    name = "experiment",
    description = "Compares strategies of recruitment by simulation, and writes a report.",
    footer = {
      "",
      "Compares affective, greedy, random and the contract net, by broadcast and by unicast,",
      "with 3, 6 and 12 vehicles, with none, a tenth, a quarter and a half of the messages",
      "lost: 96 cells. All cells use the same seeds. The same options give the same numbers.",
      "",
      "With --embedded, 16 of them run over real JERI and remote events, and are compared",
      "with the simulated network (five minutes)."
    })
final class ExperimentCommand implements Callable<Integer> {

  private static final int LEAST_SEEDS = 2; // one has no interval
  private static final int MOST_SEEDS = 10_000;
  private static final int MOST_JOBS = 256;
  private static final int EMBEDDED_JOBS = 60; // they mostly wait
  private static final double USUAL_SPEED = 25;
  private static final double FASTEST = 1000;
  private static final double LONGEST_BURST = 100; // messages

  @Option(
      names = "--seeds",
      paramLabel = "N",
      description = "Number of runs of each cell (default ${DEFAULT-VALUE}).")
  private int seeds = 30;

  @Option(
      names = "--strategy",
      paramLabel = "CLASS",
      description =
          "A strategy in addition to the four: the name of a class on DFRA_CLASSPATH; may be"
              + " repeated.")
  private List<String> more = new ArrayList<>();

  @Option(
      names = "--burst",
      paramLabel = "N",
      description =
          "Lose messages in bursts of N messages on average (default: each independently).")
  private @Nullable Double burst;

  @Option(
      names = "--delays",
      paramLabel = "FILE",
      description =
          "Use the message delays in this CSV file with a column delay_ms (default: measured"
              + " delays).")
  private @Nullable Path delays;

  @Option(
      names = "--jobs",
      paramLabel = "N",
      description = "Number of concurrent runs (default: the number of cores; with --embedded 60).")
  private @Nullable Integer jobs;

  @Option(
      names = "--embedded",
      description =
          "Run 16 of the cells over real JERI and remote events instead, and report whether the"
              + " simulated network agrees with them.")
  private boolean isEmbedded;

  @Option(
      names = "--speed",
      paramLabel = "K",
      description = "With --embedded: how much faster than real time (default 25).")
  private @Nullable Double speed;

  @Option(
      names = "--report",
      paramLabel = "DIR",
      description =
          "Where the report is written (default reports/recruit-experiment, with --embedded"
              + " reports/recruit-embedded).")
  private @Nullable Path named;

  @Mixin
  @SuppressWarnings("NullAway.Init") // set by picocli before the call
  private RecordOption record;

  @Spec
  @SuppressWarnings("NullAway.Init") // set by picocli before the call
  private CommandSpec spec;

  @Override
  public Integer call() throws Exception {
    within("--seeds", seeds, LEAST_SEEDS, MOST_SEEDS);
    int jobs = jobs();
    within("--jobs", jobs, 1, MOST_JOBS);
    Path folder =
        named != null
            ? named
            : Path.of("reports", isEmbedded ? "recruit-embedded" : "recruit-experiment");
    ExperimentPlan plan = plan();
    if (isEmbedded) {
      return embedded(plan, jobs, folder);
    }
    if (speed != null) {
      throw new ParameterException(
          spec.commandLine(), "--speed requires --embedded; simulated runs do not use real time");
    }
    List<ExperimentCell> cells = ExperimentGrid.cells(strategies(plan.shame()));
    writable(folder);
    Page.setHeadless();
    ProgressReporter progress = progress();
    progress.section("running", "Recruitment strategies compared by simulation");
    progress.say(
        "%d cells with %d seeds each are %d runs, in each of which a robot calls %d times; %d run"
            + " at once.",
        cells.size(), seeds, cells.size() * seeds, plan.calls(), jobs);
    ProgressReporter.Stopwatch watch = progress.stopwatch();
    List<CellResult> results =
        new Experiment(plan, jobs)
            .run(cells, Seeds.evaluation(seeds), new RunProgress(progress, System::nanoTime));
    Duration took = watch.elapsed();
    progress.say("All runs have finished after %.1f s.", took.toNanos() / 1e9);
    StrategyComparisonReport comparison = new StrategyComparisonReport(results);
    comparison.sentences().forEach(sentence -> progress.say("%s", sentence));
    comparison
        .figures()
        .all()
        .forEach(each -> progress.figure(each.name(), each.value(), each.target(), each.unit()));
    Path file = new ExperimentReport(plan, how(plan), comparison, took, jobs).write(folder);
    progress.say("The report is %s; runs.csv beside it has a line for each run.", file);
    progress.table();
    record.append(progress.figures(), "experiment", "recruit");
    return progress.figures().missed().isEmpty() ? ExitCode.SUCCESS : ExitCode.FAILED;
  }

  private int jobs() {
    if (jobs != null) {
      return jobs;
    }
    return isEmbedded ? EMBEDDED_JOBS : Runtime.getRuntime().availableProcessors();
  }

  private ProgressReporter progress() {
    return ProgressReporter.to(spec.commandLine().getOut());
  }

  private int embedded(ExperimentPlan plan, int atOnce, Path folder) throws Exception {
    double times = speed == null ? USUAL_SPEED : speed;
    if (!(times >= 1 && times <= FASTEST)) {
      throw new ParameterException(
          spec.commandLine(), "--speed=" + speed + " is not a number from 1 to 1000");
    }
    if (delays != null || !more.isEmpty()) {
      throw new ParameterException(
          spec.commandLine(),
          "--embedded compares two strategies of DFRA with measured delays; omit --strategy and"
              + " --delays");
    }
    writable(folder);
    Page.setHeadless();
    ProgressReporter progress = progress();
    Path file = new EmbeddedExperiment(plan, seeds, atOnce, times, progress).run(folder);
    progress.say("The report is %s; runs-real.csv beside it has a line for each run.", file);
    progress.table();
    record.append(progress.figures(), "experiment", "recruit-embedded");
    return progress.figures().missed().isEmpty() ? ExitCode.SUCCESS : ExitCode.FAILED;
  }

  private void within(String option, int number, int least, int most) {
    if (number < least || number > most) {
      throw new ParameterException(
          spec.commandLine(),
          option + "=" + number + " is not a number from " + least + " to " + most);
    }
  }

  private ExperimentPlan plan() throws IOException {
    ExperimentPlan plan = ExperimentPlan.DEFAULT;
    double length = burst == null ? 1 : burst;
    if (!(length >= 1 && length <= LONGEST_BURST)) {
      throw new ParameterException(
          spec.commandLine(), "--burst=" + burst + " is not a number from 1 to 100");
    }
    if (burst != null) {
      plan = plan.with((share, random) -> GilbertElliottLoss.bursts(share, length, random));
    }
    return delays == null ? plan : plan.with(MeasuredDelays.read(delays));
  }

  /** The four strategies and the named ones; rejects unknown names before any run. */
  private List<String> strategies(ShameSettings shame) {
    List<String> all = new ArrayList<>(ExperimentGrid.STRATEGIES);
    for (String name : more) {
      RecruitmentStrategy unused =
          StrategyRegistry.named(name, new Shame(shame), new SplittableRandom(1));
      if (!all.contains(name)) {
        all.add(name);
      }
    }
    return all;
  }

  private void writable(Path folder) {
    try {
      Files.createDirectories(folder);
      Files.delete(Files.createTempFile(folder, "report", ".tmp"));
    } catch (IOException e) {
      throw new CommandFailure(
          ExitCode.FAILED,
          "the folder --report " + folder + " cannot be written to (" + e + "); name another",
          e);
    }
  }

  /** Loss and delay of messages, for the report. */
  private String how(ExperimentPlan plan) {
    String lost =
        burst == null
            ? "Messages are lost independently of each other."
            : "Messages are lost in bursts of " + burst + " on average.";
    String slow =
        delays == null
            ? "Their delays are drawn from those of 2000 messages (message-delays-v1.csv), which the"
                + " benchmark recruit measured between two processes of one computer."
            : "Their delays are drawn from " + delays + ".";
    return lost + " " + slow;
  }
}
