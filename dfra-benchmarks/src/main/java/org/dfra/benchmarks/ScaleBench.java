package org.dfra.benchmarks;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Instant;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.function.ToDoubleFunction;
import org.dfra.benchmarks.scale.Team;
import org.dfra.benchmarks.scale.TeamResult;
import org.dfra.benchmarks.scale.TeamResult.Mutual;
import org.dfra.benchmarks.scale.TeamResult.Observed;
import org.dfra.report.measurement.ReportHead;
import org.dfra.report.plot.Axis;
import org.dfra.report.plot.HtmlReport;
import org.dfra.report.plot.LinePanel;
import org.dfra.report.plot.Page;
import org.dfra.report.plot.Series;

/**
 * Measures how threads, traffic and delays grow with the number of robots in a team. Each robot is
 * a process with a lookup service and modules of its own, so that robots share nothing.
 */
final class ScaleBench implements Bench {

  /** The sizes of teams for which the targets are stated. */
  static final List<Integer> SIZES = List.of(2, 10, 30, 100);

  private static final int MODULES = 30;
  private static final int REGISTRARS = 3;
  private static final int MAX_THREADS = 60;
  private static final double MAX_EXPONENT = 1.1;
  private static final double MAX_COMPLETE = 5;
  private static final double MAX_CALLS = 150;
  private static final int PLOT_HEIGHT = 260;

  private final List<Integer> sizes;
  private final Path folder;

  /**
   * @param sizes numbers of robots, ascending
   * @param folder for the plots
   */
  ScaleBench(List<Integer> sizes, Path folder) {
    this.sizes = List.copyOf(sizes);
    this.folder = folder;
  }

  /** One figure of a team, as it is reported and plotted. */
  private record Grown(
      String who, String quantity, String unit, ToDoubleFunction<TeamResult> value) {

    String name() {
      return who + ": " + quantity;
    }
  }

  private static final List<Grown> GROWN =
      List.of(
          new Grown("observer", "calls", "1/s", each -> each.observed().observer().calls()),
          new Grown("observer", "traffic", "B/s", each -> each.observed().observer().bytes()),
          new Grown("observer", "threads", "", each -> each.observed().observer().threads()),
          new Grown(
              "each robot, knowing all", "calls", "1/s", each -> each.mutual().robot().calls()),
          new Grown(
              "each robot, knowing all", "traffic", "B/s", each -> each.mutual().robot().bytes()),
          new Grown(
              "each robot, knowing all", "threads", "", each -> each.mutual().robot().threads()));

  @Override
  public void run(Report report) throws Exception {
    report.say(
        "Each robot is a process with a lookup service and "
            + Team.MODULES
            + " modules; of more than "
            + Team.MAX_PROCESSES
            + " robots, "
            + Team.PACKED
            + " are in a process, with discovery, directory and renewals of their own. A call counts"
            + " for the process that makes it; bytes count in both directions.");
    report.figure(
        "threads of a JVM with " + MODULES + " modules and " + REGISTRARS + " lookup services",
        Team.threadsOf(MODULES, REGISTRARS),
        MAX_THREADS,
        "");
    List<TeamResult> results = new ArrayList<>();
    for (int size : sizes) {
      try (Team team = Team.start(size, report::say)) {
        Observed observed = team.measureObserved();
        report(report, size, observed);
        Mutual mutual = team.measureMutual();
        report(report, size, mutual);
        results.add(new TeamResult(size, observed, mutual));
      }
    }
    if (results.size() > 1) {
      exponents(report, results);
      plot(report, results);
    }
  }

  private static void report(Report report, int robots, Observed observed) {
    String team = robots + " robots: ";
    report.figure(
        team + "one observer knows all after",
        observed.complete(),
        forLargest(robots, MAX_COMPLETE),
        "s");
    report.figure(
        team + "traffic of one lookup service with one observer",
        observed.observer().bytes() / robots,
        "B/s");
    report.figure(
        team + "calls of the observer to one lookup service",
        observed.observer().calls() / robots,
        "1/s");
    report.figure(team + "threads of the observer", observed.observer().threads(), "");
    report.figure(
        team + "traffic of all robots and the observer",
        observed.robots().bytes() + observed.observer().bytes(),
        "B/s");
    double[] changes = observed.changes().stream().mapToDouble(Double::doubleValue).toArray();
    report.figure(team + "a change is seen after, median", Report.quantile(changes, 0.5), "s");
    report.figure(team + "a change is seen after, longest", Report.quantile(changes, 1), "s");
  }

  private static void report(Report report, int robots, Mutual mutual) {
    String team = robots + " robots, each knowing all: ";
    report.figure(team + "a process does after, longest", mutual.complete(), "s");
    report.figure(
        team + "calls of a robot", mutual.robot().calls(), forLargest(robots, MAX_CALLS), "1/s");
    report.figure(team + "traffic of a robot", mutual.robot().bytes(), "B/s");
    report.figure(team + "threads of a robot", mutual.robot().threads(), "");
    report.figure(team + "busy cores in all", mutual.cpu(), "");
  }

  private static double forLargest(int robots, double target) {
    return robots == SIZES.get(SIZES.size() - 1) ? target : Double.POSITIVE_INFINITY;
  }

  private static void exponents(Report report, List<TeamResult> results) {
    report.figure(
        "total traffic with one observer: exponent over robots",
        exponent(results, ScaleBench::totalBytes),
        MAX_EXPONENT,
        "");
    for (Grown each : GROWN) {
      report.figure(each.name() + ": exponent over robots", exponent(results, each.value()), "");
    }
  }

  private static double totalBytes(TeamResult result) {
    return result.observed().robots().bytes() + result.observed().observer().bytes();
  }

  /** The slope of the line of least squares through the logarithms. */
  static double exponent(List<TeamResult> results, ToDoubleFunction<TeamResult> value) {
    double[] x = results.stream().mapToDouble(each -> Math.log(each.robots())).toArray();
    double[] y =
        results.stream().mapToDouble(each -> Math.log(value.applyAsDouble(each))).toArray();
    double meanX = Arrays.stream(x).average().orElseThrow();
    double meanY = Arrays.stream(y).average().orElseThrow();
    double above = 0;
    double below = 0;
    for (int i = 0; i < x.length; i++) {
      above += (x[i] - meanX) * (y[i] - meanY);
      below += (x[i] - meanX) * (x[i] - meanX);
    }
    return above / below;
  }

  private void plot(Report report, List<TeamResult> results) throws IOException {
    Files.createDirectories(folder);
    Page page = new Page("");
    int half = GROWN.size() / 2;
    for (int i = 0; i < half; i++) { // the observer's on the left, a robot's on the right
      page.row(PLOT_HEIGHT, panel(GROWN.get(i), results), panel(GROWN.get(half + i), results));
    }
    HtmlReport html = new HtmlReport("Growth with the number of robots");
    ReportHead.add(html, report.figures(), Instant.now());
    html.figure(
        page,
        String.format(
            Locale.ROOT,
            "One observer, and each robot observing all, for %d to %d robots with %d modules each.",
            results.get(0).robots(),
            results.get(results.size() - 1).robots(),
            Team.MODULES));
    Path file = folder.resolve("scale.html");
    html.write(file);
    report.say("  plotted in " + file);
  }

  private static LinePanel panel(Grown what, List<TeamResult> results) {
    double[] robots = results.stream().mapToDouble(TeamResult::robots).toArray();
    double[] values = results.stream().mapToDouble(what.value()).toArray();
    double most = Arrays.stream(values).max().orElseThrow();
    return new LinePanel(
            what.name(),
            Axis.of("robots", "").between(0, 1.05 * robots[robots.length - 1]),
            Axis.of(what.quantity(), what.unit()).between(0, 1.1 * most))
        .add(Series.line("", robots, values), Series.points("measured", robots, values));
  }
}
