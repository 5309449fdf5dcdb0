package org.dfra.examples.map;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.dfra.examples.mission.MissionProgressListener.MissionEvent;
import org.dfra.report.plot.HtmlReport;

/** Events during the run, numbered from 1: figures show the numbers, this list the texts. */
public final class MissionEventList {

  private MissionEventList() {}

  /** Adds the list, unless it is empty. */
  public static void addTo(List<MissionEvent> marks, HtmlReport html) {
    List<List<String>> rows = new ArrayList<>();
    for (MissionEvent each : marks) {
      rows.add(
          List.of(
              Integer.toString(rows.size() + 1),
              String.format(Locale.ROOT, "%.1f s", each.time()),
              each.robot(),
              each.what()));
    }
    if (!rows.isEmpty()) {
      html.heading("Events").table(List.of("Number", "Time", "Robot", "What"), rows);
    }
  }
}
