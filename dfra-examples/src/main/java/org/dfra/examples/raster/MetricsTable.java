package org.dfra.examples.raster;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.function.Function;
import org.dfra.examples.mission.MissionResult;
import org.dfra.examples.mission.MissionResult.RobotMissionResult;
import org.dfra.examples.mission.Scores;

/**
 * The table of a search's metrics, a column for each robot.
 *
 * @param headings of the columns
 * @param rows each with as many cells
 */
record MetricsTable(List<String> headings, List<List<String>> rows) {

  /** A result that others published for real robots: {@code facts} of the literature. */
  private record Published(String source, double mean, String over) {}

  private static final List<Published> PUBLISHED =
      List.of(
          new Published("Columbia AVENUE, outdoors", 0.46, "210 m, 14 waypoints"),
          new Published("Columbia AVENUE, outdoors", 0.25, "132 m, 9 waypoints"),
          new Published("ICR, odometry alone", 0.42, "40.5 m"));

  /**
   * Metrics of a whole search.
   *
   * @param scores of the robots, in their order
   * @param together share of the region that at least one of them saw
   */
  static MetricsTable of(MissionResult flight, List<Scores> scores, double together) {
    List<String> headings = new ArrayList<>(List.of("Figure"));
    flight.robots().forEach(each -> headings.add(each.robot()));
    List<List<String>> rows = new ArrayList<>();
    add(rows, "completed its lanes", scores, s -> s.completed() ? "yes" : "no");
    rows.add(collisions(flight));
    add(rows, "minimum clearance", scores, s -> metres(s.clearance()));
    add(rows, "region seen", scores, s -> percent(s.coverage()));
    add(rows, "… by it or another", scores, s -> percent(together));
    add(rows, "seen twice or more", scores, s -> percent(s.overlap()));
    add(rows, "cross-track error, estimated, RMS", scores, s -> metres(s.crossTrack().rms()));
    add(rows, "… 95 % within", scores, s -> metres(s.crossTrack().within95()));
    add(rows, "… maximum", scores, s -> metres(s.crossTrack().most()));
    add(rows, "cross-track error, true, RMS", scores, s -> metres(s.trueCrossTrack().rms()));
    add(rows, "… 95 % within", scores, s -> metres(s.trueCrossTrack().within95()));
    add(rows, "… maximum", scores, s -> metres(s.trueCrossTrack().most()));
    add(rows, "waypoint error, mean", scores, s -> metres(s.waypointErrors().mean()));
    add(rows, "… maximum", scores, s -> metres(s.waypointErrors().most()));
    add(rows, "true error of the estimate, RMS", scores, s -> metres(s.estimateError()));
    add(rows, "true error of the last fix, RMS", scores, s -> metres(s.fixError()));
    team(rows, flight);
    add(rows, "distance driven", scores, s -> metres(s.length()));
    add(
        rows,
        "… divided by the lanes' length",
        scores,
        s -> number(s.length() / s.plannedLength()));
    add(rows, "time", scores, s -> String.format(Locale.ROOT, "%.0f s", s.seconds()));
    return new MetricsTable(headings, rows);
  }

  /** The first robot's last report about each other robot. */
  private static void team(List<List<String>> rows, MissionResult flight) {
    if (flight.robots().size() < 2) {
      return;
    }
    RobotMissionResult first = flight.robots().get(0);
    List<String> clocks = new ArrayList<>(List.of("clock offset to " + first.robot()));
    List<String> distances = new ArrayList<>(List.of("… error of the distance, RMS"));
    clocks.add("-");
    distances.add("-");
    for (RobotMissionResult other : flight.robots().subList(1, flight.robots().size())) {
      clocks.add(
          first.readings().teammates().stream()
              .filter(each -> each.robot().equals(other.robot()))
              .reduce((before, after) -> after)
              .map(each -> each.clock().toString())
              .orElse("unknown"));
      distances.add(metres(RobotSeparation.rms(RobotSeparation.all(first, other))));
    }
    rows.add(clocks);
    rows.add(distances);
  }

  private static List<String> collisions(MissionResult flight) {
    List<String> row = new ArrayList<>(List.of("collisions"));
    flight
        .robots()
        .forEach(
            robot ->
                row.add(
                    Long.toString(
                        flight.collisions().stream()
                            .filter(each -> each.robot().equals(robot.robot()))
                            .count())));
    return row;
  }

  /** Published cross-track errors, beside those of these robots. */
  static MetricsTable besidePublished(MissionResult flight, List<Scores> scores) {
    List<List<String>> rows = new ArrayList<>();
    for (int i = 0; i < scores.size(); i++) {
      Scores each = scores.get(i);
      String robot = flight.robots().get(i).robot();
      String over = String.format(Locale.ROOT, "%.0f m", each.length());
      rows.add(List.of(robot + ", true", metres(each.trueCrossTrack().mean()), over));
      rows.add(List.of(robot + ", estimated", metres(each.crossTrack().mean()), over));
    }
    for (Published each : PUBLISHED) {
      rows.add(List.of(each.source(), metres(each.mean()), each.over()));
    }
    return new MetricsTable(List.of("Robot", "Cross-track error, mean", "Over"), rows);
  }

  private static void add(
      List<List<String>> rows, String what, List<Scores> scores, Function<Scores, String> text) {
    List<String> row = new ArrayList<>(List.of(what));
    scores.forEach(each -> row.add(text.apply(each)));
    rows.add(row);
  }

  private static String metres(double value) {
    return Double.isFinite(value) ? number(value) + " m" : "-";
  }

  private static String number(double value) {
    return Double.isFinite(value) ? String.format(Locale.ROOT, "%.2f", value) : "-";
  }

  private static String percent(double share) {
    return String.format(Locale.ROOT, "%.1f %%", 100 * share);
  }
}
