package org.dfra.app.recruit;

import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
import java.util.Locale;
import org.dfra.app.measurement.ReportHead;
import org.dfra.app.plot.HtmlReport;
import org.dfra.app.plot.Page;
import org.dfra.recruit.experiment.Estimate;
import org.dfra.recruit.experiment.ExperimentPlan;
import org.dfra.recruit.experiment.Metric;
import org.dfra.recruit.transport.MessageMode;

/**
 * Writes the report of an experiment: a page with figures and tables, each figure as SVG, all
 * numbers as CSV.
 */
final class ExperimentReport {

  private final ExperimentPlan plan;
  private final String messages;
  private final StrategyComparison comparison;
  private final Duration took;
  private final int jobs;

  /**
   * @param messages description of their loss and delay
   * @param took duration, in real time
   * @param jobs number of parallel runs
   */
  ExperimentReport(
      ExperimentPlan plan,
      String messages,
      StrategyComparison comparison,
      Duration took,
      int jobs) {
    this.plan = plan;
    this.messages = messages;
    this.comparison = comparison;
    this.took = took;
    this.jobs = jobs;
  }

  /**
   * Writes it.
   *
   * @return the file to open
   */
  Path write(Path folder) throws IOException {
    Files.createDirectories(folder);
    HtmlReport html = new HtmlReport("Who comes when a robot calls");
    ExperimentTables tables = new ExperimentTables(comparison, html);
    ReportHead.add(html, comparison.figures(), Instant.now());
    setting(html);
    judgement(folder, html, tables);
    for (Metric metric : Metric.values()) {
      metric(folder, html, tables, metric);
    }
    html.heading("How transmissions change with the team and the loss")
        .paragraph(
            "Each line is the mean of paired differences, of the same seed with other vehicles or"
                + " another loss.");
    tables.trends(Metric.TRANSMISSIONS);
    html.heading("The numbers")
        .paragraph(
            "runs.csv beside this file has a line for each run, nothing averaged; cells.csv every"
                + " mean with its interval; claims.csv every comparison. Every figure is an SVG"
                + " there. The same options give the same numbers, however many runs go on at"
                + " once.");
    new ExperimentCsv(folder).write(comparison);
    Path file = folder.resolve("report.html");
    html.write(file);
    return file;
  }

  private void setting(HtmlReport html) {
    int seeds = comparison.results().get(0).runs().size();
    html.paragraph(
        String.format(
            Locale.ROOT,
            "In a field of 100 m by 100 m an aircraft scans at 5 m/s and calls for help %d times,"
                + " every %d s, at places by chance. Ground vehicles drive 1 m/s: two of them scan"
                + " half of the field each, the others stand. A call succeeds if a helper has come"
                + " and both sides know, within %d s. Nothing of the agents is simulated but what"
                + " they live in: robots, network and time.",
            plan.calls(),
            plan.period().toSeconds(),
            plan.deadline().toSeconds()));
    html.paragraph(
        String.format(
            Locale.ROOT,
            "%d cells, %d runs each. Every cell has the same seeds, none of which was used to"
                + " choose a constant. %s",
            comparison.results().size(),
            seeds,
            messages));
    html.paragraph(
        "A broadcast is lost or heard by each robot by itself, as messages to each are. So a seed"
            + " gives the same course of events by broadcast and by unicast, and only the count of"
            + " transmissions tells them apart.");
    double load = ManagementFactory.getOperatingSystemMXBean().getSystemLoadAverage();
    html.paragraph(
        String.format(
            Locale.ROOT,
            "It took %.0f s, %d runs at once, on a computer with %d cores under a load of %.1f.",
            took.toNanos() / 1e9,
            jobs,
            Runtime.getRuntime().availableProcessors(),
            load));
    html.paragraph(
        "The idea of affective recruitment and its protocol are from the literature; the equations"
            + " of shame, the time-outs and this field are the project's own. So signs and trends"
            + " are claimed here, and no published number is reproduced.");
  }

  private void judgement(Path folder, HtmlReport html, ExperimentTables tables) throws IOException {
    html.heading("Where affective recruitment wins, and where it loses");
    comparison.sentences().forEach(html::paragraph);
    Estimate failed = comparison.failedMildly();
    html.paragraph(
        String.format(
            Locale.ROOT,
            "Of its calls at a loss up to 25 %%, in teams of three too, a share of %.4f (%.4f to"
                + " %.4f) had no help in time.",
            failed.value(),
            failed.low(),
            failed.high()));
    add(
        folder,
        html,
        "difference",
        new ExperimentCharts(comparison).difference(Metric.TRANSMISSIONS),
        "Above the line at 0 the other sends more, and affective recruitment wins; below it, it"
            + " loses. Intervals are of 95 %.");
    html.paragraph(
        "In how many of twelve cells it wins and loses. A win or a loss is a paired difference"
            + " whose interval of 95 % does not hold 0; where there is no difference at all, one"
            + " cell in forty would seem a win by chance, and one a loss.");
    tables.verdicts();
  }

  private void metric(Path folder, HtmlReport html, ExperimentTables tables, Metric metric)
      throws IOException {
    String title = ExperimentTables.title(metric);
    html.heading(ExperimentCharts.sentence(title));
    html.paragraph(meaning(metric));
    String name = metric.name().toLowerCase(Locale.ROOT).replace('_', '-');
    add(
        folder,
        html,
        name,
        new ExperimentCharts(comparison).metric(metric),
        "Intervals are of 95 %. Strategies stand a little beside each other, at the same loss.");
    for (MessageMode mode : MessageMode.values()) {
      html.paragraph("By " + StrategyComparison.name(mode) + ":");
      tables.metric(metric, mode);
    }
    html.paragraph("Where affective recruitment differs:");
    tables.claims(metric);
  }

  private static String meaning(Metric metric) {
    return switch (metric) {
      case TRANSMISSIONS ->
          "Messages sent for each recruitment that was completed, a broadcast counted once. What"
              + " failed calls cost is in it.";
      case RECEPTIONS -> "The same with a broadcast counted once for each robot that it is for.";
      case ALLOCATION -> "From the call to the first choice of a helper; where one was chosen.";
      case ARRIVAL ->
          "From the call to the helper's arrival, as the caller hears of it; where one came.";
      case FAILURES ->
          "Calls in which no helper had come within the deadline, or not both sides knew. Intervals"
              + " are Wilson's.";
      case DUPLICATE_HELPERS ->
          "How often a second robot was on its way to a call, or there. Tables have the sum of all"
              + " runs.";
      case ORPHANED_HELPERS ->
          "How often a robot was on its way or there for longer than 2 s although its requester did"
              + " not count on it; a robot that was not free in the end is one too. Tables have the"
              + " sum of all runs.";
      case REGRET -> "How much longer the chosen robot needs than the nearest free one.";
      case RASTER_TIME_LOST -> "For how long scanners were away from their route, both together.";
      case TRAVEL -> "What each vehicle drove for others and back, in the mean.";
    };
  }

  private static void add(Path folder, HtmlReport html, String name, Page page, String caption)
      throws IOException {
    html.figure(page, caption, folder.resolve(name + ".svg"));
  }
}
