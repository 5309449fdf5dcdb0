package org.dfra.examples.recruit;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Instant;
import java.util.Locale;
import org.dfra.examples.map.MissionEventList;
import org.dfra.examples.recruit.Conversations.Attempt;
import org.dfra.examples.recruit.DemoTimeline.Event;
import org.dfra.geometry.LocalPosition;
import org.dfra.report.measurement.ReportHead;
import org.dfra.report.measurement.RunMeasurements;
import org.dfra.report.plot.HtmlReport;
import org.dfra.report.plot.Page;

/**
 * Writes the events, messages and affective state: one file, and each of its figures as a separate
 * SVG.
 */
final class RecruitReport {

  private final DemoTimeline timeline;
  private final RecruitCharts figures;
  private final double speed;
  private final RunMeasurements measured;

  /**
   * @param speed seconds of the robots' time per second
   * @param measured values that decide whether it passed
   */
  RecruitReport(
      DemoTimeline timeline, RecruitCharts figures, double speed, RunMeasurements measured) {
    this.timeline = timeline;
    this.figures = figures;
    this.speed = speed;
    this.measured = measured;
  }

  /**
   * Writes it.
   *
   * @return the report's file
   */
  Path write(Path folder) throws IOException {
    Files.createDirectories(folder);
    HtmlReport report = new HtmlReport("Robots that help each other");
    ReportHead.add(report, measured, Instant.now());
    report.paragraph(
        String.format(
            Locale.ROOT,
            "The robots' bodies, drivers and behaviours were embedded in one virtual machine; each"
                + " agent ran in a process of its own. All times are seconds of the robots' time"
                + " since the demonstration began, which passed %s times as fast as real time.",
            speed));
    MissionEventList.addTo(timeline.events().stream().map(Event::mark).toList(), report);
    report.heading("Paths");
    add(
        folder.resolve("map.svg"),
        report,
        figures.map(),
        "True paths in the simulated world. A ring is a robot's start, a square its end; arrows"
            + " show its direction, and a robot that did not move has its ring only. The numbers"
            + " refer to the list of events: a call is at the place where help was requested, all"
            + " other events where the robot was.");
    report
        .heading("Messages")
        .paragraph(
            "A chart shows what was sent, and when by the sender's clock; not whether it arrived."
                + " A message to all has an arrow to each. ACCEPT gives the time that the robot would"
                + " take, ARRIVAL how long it can stay. A robot that does not arrive is replaced in a"
                + " second attempt.");
    for (Attempt each : timeline.conversations()) {
      LocalPosition at = timeline.place(each.asked().position());
      add(
          folder.resolve(each.file() + ".svg"),
          report,
          figures.chart(each),
          String.format(
              Locale.ROOT,
              "Help was requested at %.0f m east and %.0f m north.",
              at.east(),
              at.north()));
    }
    report.heading("Shame");
    add(
        folder.resolve("shame.svg"),
        report,
        figures.shame(),
        "Each call that a robot receives and does not answer adds to its shame; at 1 it offers"
            + " help. It is 0 once a helper is chosen. The numbers refer to the list of events.");
    Path file = folder.resolve("report.html");
    report.write(file);
    return file;
  }

  private static void add(Path svg, HtmlReport report, Page page, String caption)
      throws IOException {
    report.figure(page, caption, svg);
  }
}
