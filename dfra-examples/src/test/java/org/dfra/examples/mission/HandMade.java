package org.dfra.examples.mission;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.dfra.behaviors.raster.RasterPlan;
import org.dfra.behaviors.raster.Region;
import org.dfra.examples.mission.MissionResult.RobotMissionResult;
import org.dfra.examples.mission.RobotLog.Sample;
import org.dfra.geometry.GeoPosition;
import org.dfra.geometry.LocalFrame;
import org.dfra.geometry.LocalPosition;

/** Searches whose scores are known beforehand. */
public final class HandMade {

  private static final LocalFrame FIELD = new LocalFrame(new GeoPosition(48, 11, 0));

  private HandMade() {}

  /** 8 m from west to east, 20 m from south to north. */
  public static Region region() {
    List<GeoPosition> corners = new ArrayList<>();
    for (double[] each : new double[][] {{0, 0}, {8, 0}, {8, 20}, {0, 20}}) {
      corners.add(FIELD.toGeo(new LocalPosition(each[0], each[1], 0)));
    }
    return Region.of(corners);
  }

  /** Four lanes, 2 m apart, 8 waypoints. */
  public static RasterPlan plan() {
    return RasterPlan.of(region(), 2.001, 2, RasterPlan.NORTHWARD);
  }

  /**
   * A robot that drives a plan at 1 m/s.
   *
   * @param truly metres that it truly is to the east of the plan
   * @param believed metres that it believes to be there
   * @param waypoints after which it gives up
   */
  public static List<Sample> drive(RasterPlan plan, double truly, double believed, int waypoints) {
    List<Sample> samples = new ArrayList<>();
    int count = plan.path().size();
    for (int i = 1; i < waypoints; i++) {
      LocalPosition from = plan.path().get(i - 1);
      LocalPosition to = plan.path().get(i);
      double length = Math.hypot(to.east() - from.east(), to.north() - from.north());
      for (double along = 0; along < length - 0.05; along += 0.1) {
        double part = along / length;
        samples.add(
            at(
                samples.size() / 10.0,
                from.east() + part * (to.east() - from.east()),
                from.north() + part * (to.north() - from.north()),
                truly,
                believed,
                (double) i / count));
      }
    }
    LocalPosition last = plan.path().get(waypoints - 1);
    samples.add(
        at(
            samples.size() / 10.0,
            last.east(),
            last.north(),
            truly,
            believed,
            (double) waypoints / count));
    return samples;
  }

  private static Sample at(
      double time, double east, double north, double truly, double believed, double done) {
    return new Sample(
        time,
        east + truly,
        north,
        0,
        1,
        east + believed,
        north,
        0,
        east + truly + 3,
        north + 4, // a fix that is 5 m off
        done,
        2 - done);
  }

  /** The result of a robot of which only the path was recorded. */
  public static RobotMissionResult flight(List<Sample> samples, boolean isCompleted) {
    return new RobotMissionResult(
        "atrv1", isCompleted, "it ends", samples, Map.of(), ModuleReadings.EMPTY);
  }
}
