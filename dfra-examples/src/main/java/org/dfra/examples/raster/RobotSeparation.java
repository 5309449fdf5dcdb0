package org.dfra.examples.raster;

import java.util.ArrayList;
import java.util.List;
import org.dfra.examples.mission.MissionResult.RobotMissionResult;
import org.dfra.examples.mission.ModuleReadings.TeammateDistance;
import org.dfra.examples.mission.RobotLog.Sample;

/**
 * Distance of two robots at an instant, from base to base: by their estimates, as one of them
 * reported it, and by ground truth.
 *
 * @param time seconds since the search began
 * @param estimated metres
 * @param actual metres
 */
record RobotSeparation(double time, double estimated, double actual) {

  /** Maximum interval of samples for interpolation, seconds. */
  private static final double WIDEST = 0.5;

  /**
   * All distances to another robot that one robot reported, where both true positions are known.
   */
  public static List<RobotSeparation> all(RobotMissionResult teller, RobotMissionResult other) {
    List<RobotSeparation> all = new ArrayList<>();
    int moments = Math.min(teller.samples().size(), other.samples().size());
    int next = 1;
    for (TeammateDistance each : teller.readings().teammates()) {
      if (!each.robot().equals(other.robot())) {
        continue;
      }
      while (next < moments && teller.samples().get(next).time() < each.time()) {
        next++;
      }
      if (next >= moments) {
        break;
      }
      Sample before = teller.samples().get(next - 1);
      Sample after = teller.samples().get(next);
      if (each.time() < before.time() || after.time() - before.time() > WIDEST) {
        continue;
      }
      double part = (each.time() - before.time()) / (after.time() - before.time());
      Sample thereBefore = other.samples().get(next - 1);
      Sample thereAfter = other.samples().get(next);
      double east =
          (1 - part) * (thereBefore.east() - before.east())
              + part * (thereAfter.east() - after.east());
      double north =
          (1 - part) * (thereBefore.north() - before.north())
              + part * (thereAfter.north() - after.north());
      all.add(new RobotSeparation(each.time(), each.distance(), Math.hypot(east, north)));
    }
    return all;
  }

  /** Error of the estimates, root mean square, metres; NaN if there are none. */
  public static double rms(List<RobotSeparation> all) {
    double squares = 0;
    for (RobotSeparation each : all) {
      squares += (each.estimated - each.actual) * (each.estimated - each.actual);
    }
    return Math.sqrt(squares / all.size());
  }
}
