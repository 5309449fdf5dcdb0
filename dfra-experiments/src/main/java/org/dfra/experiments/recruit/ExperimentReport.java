package org.dfra.experiments.recruit;

import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
import java.util.Locale;
import org.dfra.experiments.recruit.simulation.Estimate;
import org.dfra.experiments.recruit.simulation.ExperimentPlan;
import org.dfra.experiments.recruit.simulation.Metric;
import org.dfra.recruit.transport.Transport.MessageMode;
import org.dfra.report.measurement.ReportHead;
import org.dfra.report.plot.HtmlReport;
import org.dfra.report.plot.Page;

/**
 * Writes the report of an experiment: a page with figures and tables, each figure as SVG, all
 * numbers as CSV.
 */
final class ExperimentReport {

  private final ExperimentPlan plan;
  private final String messages;
  private final StrategyComparisonReport comparison;
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
      StrategyComparisonReport comparison,
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
    HtmlReport html = new HtmlReport("Recruitment strategies compared by simulation");
    ExperimentTables tables = new ExperimentTables(comparison, html);
    ReportHead.add(html, comparison.figures(), Instant.now());
    setting(html);
    judgement(folder, html, tables);
    for (Metric metric : Metric.values()) {
      metric(folder, html, tables, metric);
    }
    html.heading("How transmissions change with the team and the loss")
        .paragraph(
            "Each line is the mean of paired differences: the same seed with another number of"
                + " vehicles or another loss.");
    tables.trends(Metric.TRANSMISSIONS);
    html.heading("The numbers")
        .paragraph(
            "Beside this file, runs.csv has a line for each run; cells.csv has every mean with its"
                + " interval, and claims.csv every comparison. Every figure is an SVG file there."
                + " The same options give the same numbers, regardless of the number of concurrent"
                + " runs.");
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
                + " every %d s, at random places. Ground vehicles drive at 1 m/s: two of them scan"
                + " half of the field each, the others are idle. A call succeeds if a helper has"
                + " arrived and both sides have confirmed that within %d s. The agents are the real"
                + " ones; robots, network and time are simulated.",
            plan.calls(),
            plan.period().toSeconds(),
            plan.deadline().toSeconds()));
    html.paragraph(
        String.format(
            Locale.ROOT,
            "There are %d cells with %d runs each. All cells use the same seeds, none of which was"
                + " used to choose a constant. %s",
            comparison.results().size(),
            seeds,
            messages));
    html.paragraph(
        "Each robot receives or loses a broadcast independently, like a unicast message. So a seed"
            + " gives the same events by broadcast and by unicast; only the number of"
            + " transmissions differs.");
    double load = ManagementFactory.getOperatingSystemMXBean().getSystemLoadAverage();
    html.paragraph(
        String.format(
            Locale.ROOT,
            "The experiment took %.0f s with %d concurrent runs on a computer with %d cores and a load of %.1f.",
            took.toNanos() / 1e9,
            jobs,
            Runtime.getRuntime().availableProcessors(),
            load));
    html.paragraph(
        "The idea of affective recruitment and its protocol are from the literature; the equations"
            + " of shame, the timeouts and this field are DFRA's own. So signs and trends"
            + " are claimed here, and no published number is reproduced.");
  }

  private void judgement(Path folder, HtmlReport html, ExperimentTables tables) throws IOException {
    html.heading("Where affective recruitment wins, and where it loses");
    comparison.sentences().forEach(html::paragraph);
    Estimate failed = comparison.failedMildly();
    html.paragraph(
        String.format(
            Locale.ROOT,
            "At a loss up to 25 %%, in teams of three too, a fraction of %.4f (%.4f to %.4f) of its"
                + " calls had no help in time.",
            failed.value(),
            failed.low(),
            failed.high()));
    add(
        folder,
        html,
        "difference",
        new ExperimentCharts(comparison).difference(Metric.TRANSMISSIONS),
        "Above 0 the other strategy sends more, and affective recruitment wins; below 0 it loses."
            + " Intervals are of 95 %.");
    html.paragraph(
        "The table counts in how many of twelve cells it wins and loses. A win or a loss is a"
            + " paired difference whose interval of 95 % does not contain 0; without any real"
            + " difference, one cell in forty would be a win by chance, and one a loss.");
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
        "Intervals are of 95 %. Strategies at the same loss are drawn side by side.");
    for (MessageMode mode : MessageMode.values()) {
      html.paragraph("By " + StrategyComparisonReport.name(mode) + ":");
      tables.metric(metric, mode);
    }
    html.paragraph("Where affective recruitment differs:");
    tables.claims(metric);
  }

  private static String meaning(Metric metric) {
    return switch (metric) {
      case TRANSMISSIONS ->
          "Messages sent for each completed recruitment; a broadcast counts once. Messages of"
              + " failed calls are included.";
      case RECEPTIONS -> "The same, but a broadcast counts once for each receiver.";
      case ALLOCATION -> "Time from the call to the first choice of a helper, if one was chosen.";
      case ARRIVAL ->
          "Time from the call until the requester is notified of the helper's arrival, if one arrived.";
      case FAILURES ->
          "Calls without a helper's arrival within the deadline, or not confirmed by both sides."
              + " Intervals are Wilson's.";
      case DUPLICATE_HELPERS ->
          "How often a second robot was on its way to a call, or had arrived. Tables have the sum"
              + " of all runs.";
      case ORPHANED_HELPERS ->
          "How often a robot was on its way or had arrived for longer than 2 s without being its"
              + " requester's helper; a robot that was not free at the end counts too. Tables have"
              + " the sum of all runs.";
      case REGRET ->
          "Additional travel time of the chosen robot compared with the nearest free one.";
      case RASTER_TIME_LOST ->
          "Time for which the two scanners were away from their routes, in sum.";
      case TRAVEL -> "Mean distance that a vehicle drove to help others and back.";
    };
  }

  private static void add(Path folder, HtmlReport html, String name, Page page, String caption)
      throws IOException {
    html.figure(page, caption, folder.resolve(name + ".svg"));
  }
}
