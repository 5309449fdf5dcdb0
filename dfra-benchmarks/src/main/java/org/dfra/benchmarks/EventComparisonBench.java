package org.dfra.benchmarks;

import org.dfra.benchmarks.event.EventComparison;
import org.dfra.benchmarks.event.EventSettings;

/** Compares the latency of events with that of a bare TCP program that sends as many bytes. */
final class EventComparisonBench implements Bench {

  private static final int COLUMNS = 132;

  private final EventSettings settings;

  EventComparisonBench(EventSettings settings) {
    this.settings = settings;
  }

  @Override
  public void run(Report report) throws Exception {
    report.say(
        "Events from a source's process to "
            + settings.listeners()
            + " listeners' processes on this computer. Each figure is the median of "
            + settings.repetitions()
            + (settings.repetitions() == 1 ? " repetition" : " repetitions")
            + ", each in new JVMs; the lowest and the highest are in parentheses.");
    EventComparison.descriptions().forEach(report::say);
    EventComparison comparison = new EventComparison(settings);
    comparison.run(report::say);
    report.say("");
    comparison.table().lines(COLUMNS).forEach(report::say);
    report.say("");
    comparison.figures().forEach(report.figures()::add);
  }
}
