package org.dfra.examples.raster;

import java.io.BufferedWriter;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Collection;
import java.util.List;
import java.util.Locale;
import java.util.function.Function;
import org.dfra.behaviors.raster.RasterPlan;
import org.dfra.examples.mission.CrossTrackError;
import org.dfra.examples.mission.MissionResult;
import org.dfra.examples.mission.MissionResult.RobotMissionResult;
import org.dfra.examples.mission.Scenario;
import org.dfra.examples.mission.Scores;
import org.dfra.geometry.GeoPosition;
import org.dfra.geometry.LocalPosition;

/**
 * All numbers of a search as CSV. Times are seconds on the robots' clock since the search began;
 * positions are metres east and north of the region's centre.
 */
final class RasterCsv {

  private final Path folder;

  /**
   * @param folder for the files; it exists
   */
  RasterCsv(Path folder) {
    this.folder = folder;
  }

  /**
   * Writes all files.
   *
   * @param scores of the robots, in their order
   */
  void write(Scenario scenario, MissionResult flight, List<Scores> scores) throws IOException {
    for (int i = 0; i < flight.robots().size(); i++) {
      write(flight.robots().get(i), scenario.plan(i));
    }
    scores(flight, scores);
    rows(
        "events.csv",
        "number,time_s,robot,what",
        flight.events(),
        each ->
            line(
                "%d,%.3f,%s,%s",
                flight.events().indexOf(each) + 1, each.time(), each.robot(), quoted(each.what())));
    rows(
        "collisions.csv",
        "time,robot,other,speed_mps",
        flight.collisions(),
        each -> line("%s,%s,%s,%.4f", each.time(), each.robot(), each.other(), each.speed()));
  }

  private void write(RobotMissionResult flight, RasterPlan plan) throws IOException {
    String robot = flight.robot();
    rows(
        robot + "-path.csv",
        "time_s,east_m,north_m,yaw_rad,speed_mps,estimated_east_m,estimated_north_m,"
            + "estimated_yaw_rad,fix_east_m,fix_north_m,done,clearance_m",
        flight.samples(),
        s ->
            line(
                "%.1f,%.4f,%.4f,%.5f,%.4f,%.4f,%.4f,%.5f,%.4f,%.4f,%.5f,%.4f",
                s.time(),
                s.east(),
                s.north(),
                s.yaw(),
                s.speed(),
                s.estimatedEast(),
                s.estimatedNorth(),
                s.estimatedYaw(),
                s.fixEast(),
                s.fixNorth(),
                s.done(),
                s.clearance()));
    rows(
        robot + "-cross-track.csv",
        "time_s,lane,estimated_m,true_m",
        CrossTrackError.all(flight.samples(), plan),
        each ->
            line("%.1f,%d,%.4f,%.4f", each.time(), each.lane(), each.estimated(), each.actual()));
    rows(
        robot + "-fixes.csv",
        "time_s,receiver,east_m,north_m",
        flight.readings().fixes(),
        each -> line("%.3f,%s,%.4f,%.4f", each.time(), each.receiver(), each.east(), each.north()));
    rows(
        robot + "-advice.csv",
        "time_s,speed_mps,yaw_rate_radps,strength,rule",
        flight.readings().advice(),
        each ->
            line(
                "%.3f,%.4f,%.4f,%.4f,%s",
                each.time(), each.speed(), each.yawRate(), each.strength(), quoted(each.reason())));
    rows(
        robot + "-clearance.csv",
        "time_s,left_m,centre_m,right_m",
        flight.readings().clearances(),
        each -> line("%.3f,%.4f,%.4f,%.4f", each.time(), each.left(), each.centre(), each.right()));
    rows(
        robot + "-teammates.csv",
        "time_s,robot,distance_m,clock_s,clock_within_s",
        flight.readings().teammates(),
        each ->
            line(
                "%.3f,%s,%.4f,%.6f,%.6f",
                each.time(),
                each.robot(),
                each.distance(),
                each.clock().seconds(),
                each.clock().uncertaintySeconds()));
    waypoints(robot, plan);
  }

  private void waypoints(String robot, RasterPlan plan) throws IOException {
    try (BufferedWriter out = Files.newBufferedWriter(folder.resolve(robot + "-waypoints.csv"))) {
      out.write("waypoint,latitude_deg,longitude_deg,east_m,north_m\n");
      for (int i = 0; i < plan.waypoints().size(); i++) {
        GeoPosition geo = plan.waypoints().get(i);
        LocalPosition at = plan.path().get(i);
        out.write(
            line(
                "%d,%.9f,%.9f,%.4f,%.4f",
                i + 1, geo.latitude(), geo.longitude(), at.east(), at.north()));
        out.write('\n');
      }
    }
  }

  private void scores(MissionResult flight, List<Scores> scores) throws IOException {
    try (BufferedWriter out = Files.newBufferedWriter(folder.resolve("metrics.csv"))) {
      out.write(
          "robot,completed,seconds,length_m,ideal_m,coverage,overlap,cross_track_rms_m,"
              + "cross_track_95_m,cross_track_max_m,true_cross_track_rms_m,"
              + "true_cross_track_95_m,true_cross_track_max_m,miss_mean_m,miss_max_m,"
              + "estimate_error_m,fix_error_m,clearance_m,ending\n");
      for (int i = 0; i < scores.size(); i++) {
        Scores s = scores.get(i);
        RobotMissionResult robot = flight.robots().get(i);
        out.write(
            line(
                "%s,%b,%.1f,%.3f,%.3f,%.5f,%.5f,%.4f,%.4f,%.4f,%.4f,%.4f,%.4f,%.4f,%.4f,%.4f,%.4f,"
                    + "%.4f,%s",
                robot.robot(),
                s.completed(),
                s.seconds(),
                s.length(),
                s.plannedLength(),
                s.coverage(),
                s.overlap(),
                s.crossTrack().rms(),
                s.crossTrack().within95(),
                s.crossTrack().most(),
                s.trueCrossTrack().rms(),
                s.trueCrossTrack().within95(),
                s.trueCrossTrack().most(),
                s.waypointErrors().mean(),
                s.waypointErrors().most(),
                s.estimateError(),
                s.fixError(),
                s.clearance(),
                quoted(robot.ending())));
        out.write('\n');
      }
    }
  }

  private <T> void rows(String file, String header, Collection<T> all, Function<T, String> row)
      throws IOException {
    try (BufferedWriter out = Files.newBufferedWriter(folder.resolve(file))) {
      out.write(header);
      out.write('\n');
      for (T each : all) {
        out.write(row.apply(each));
        out.write('\n');
      }
    }
  }

  private static String line(String format, Object... values) {
    return String.format(Locale.ROOT, format, values);
  }

  private static String quoted(String text) {
    return '"' + text.replace("\"", "\"\"") + '"';
  }
}
