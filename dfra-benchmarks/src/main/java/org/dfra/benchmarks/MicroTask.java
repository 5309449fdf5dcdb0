package org.dfra.benchmarks;

import java.io.PrintStream;
import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.regex.Pattern;
import org.dfra.benchmarks.micro.MicroBenchmark;
import org.dfra.benchmarks.task.Task;
import org.openjdk.jmh.results.RunResult;
import org.openjdk.jmh.runner.Runner;
import org.openjdk.jmh.runner.RunnerException;
import org.openjdk.jmh.runner.options.Options;
import org.openjdk.jmh.runner.options.OptionsBuilder;
import org.openjdk.jmh.runner.options.TimeValue;
import org.openjdk.jmh.util.Statistics;

/**
 * Runs benchmarks by JMH's runner, which starts a virtual machine for each, with the options of
 * this one. It is a process of its own, since runner and virtual machines send each other objects
 * of JMH's classes, and the filters of {@code ./dfra} refuse these.
 *
 * <p>Arguments: those of {@link #arguments}. It prints {@code round NUMBER ID} before each
 * benchmark, {@code result ID MEDIAN P99} after it, in microseconds, and at the end {@code done} or
 * {@code failed REASON}. What JMH prints is in the log.
 */
public final class MicroTask implements Task {

  private static final double MEDIAN = 50;
  private static final double P99 = 99;
  private static final int FIXED_ARGUMENTS = 3;

  /** For {@link org.dfra.benchmarks.task.TaskProcess}. */
  public MicroTask() {}

  /** The arguments that run these. */
  public static String[] arguments(MicroSettings settings, List<MicroBenchmark> chosen) {
    List<String> arguments = new ArrayList<>();
    arguments.add(Integer.toString(settings.rounds()));
    arguments.add(Integer.toString(settings.warmUpMillis()));
    arguments.add(Integer.toString(settings.measuredMillis()));
    chosen.forEach(each -> arguments.add(each.id()));
    return arguments.toArray(String[]::new);
  }

  @Override
  public void run(String[] args, PrintStream out) throws RunnerException {
    MicroSettings settings =
        new MicroSettings(
            Integer.parseInt(args[0]), Integer.parseInt(args[1]), Integer.parseInt(args[2]));
    List<String> ids = List.of(args).subList(FIXED_ARGUMENTS, args.length);
    List<MicroBenchmark> chosen =
        MicroBenchmark.ALL.stream().filter(each -> ids.contains(each.id())).toList();
    String current = "";
    try {
      for (int round = 1; round <= settings.rounds(); round++) {
        for (MicroBenchmark each : chosen) {
          current = each.id();
          out.println("round " + round + " " + each.id());
          Statistics times = measure(each, settings);
          out.println(
              "result "
                  + each.id()
                  + " "
                  + times.getPercentile(MEDIAN)
                  + " "
                  + times.getPercentile(P99));
        }
      }
      out.println("done");
    } catch (RunnerException e) {
      out.println("failed " + current + ": " + reason(e));
      throw e; // whole in the log
    }
  }

  private static Statistics measure(MicroBenchmark benchmark, MicroSettings settings)
      throws RunnerException {
    Options options =
        new OptionsBuilder()
            .include("^" + Pattern.quote(benchmark.name()) + "$")
            .forks(1)
            .warmupIterations(1)
            .warmupTime(TimeValue.milliseconds(settings.warmUpMillis()))
            .measurementIterations(1)
            .measurementTime(TimeValue.milliseconds(settings.measuredMillis()))
            .shouldFailOnError(true)
            .build();
    Collection<RunResult> results = new Runner(options).run();
    if (results.size() != 1) {
      throw new RunnerException(
          benchmark.name() + " has " + results.size() + " results instead of one");
    }
    return results.iterator().next().getPrimaryResult().getStatistics();
  }

  /** The causes in one line. */
  private static String reason(Throwable thrown) {
    StringBuilder reason = new StringBuilder();
    for (Throwable each = thrown; each != null; each = each.getCause()) {
      reason.append(reason.isEmpty() ? "" : ": ").append(each.getMessage());
      for (Throwable suppressed : each.getSuppressed()) {
        reason.append("; ").append(suppressed);
      }
    }
    return reason.toString().replaceAll("\\s+", " ");
  }

  /**
   * How long is measured. In each round, each benchmark runs in a new virtual machine: first to
   * warm up, then it is measured. So a disturbance that lasts longer than a round affects all
   * benchmarks, and hardly their ratios.
   *
   * @param rounds number of rounds
   * @param warmUpMillis to warm up, milliseconds
   * @param measuredMillis measured, milliseconds
   */
  public record MicroSettings(int rounds, int warmUpMillis, int measuredMillis) {

    /** For records. */
    public static final MicroSettings FULL = new MicroSettings(3, 2000, 3000);

    /** To try it; the figures are not to be compared. */
    public static final MicroSettings QUICK = new MicroSettings(1, 200, 400);
  }
}
