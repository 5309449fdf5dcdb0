package org.dfra.app.raster;

import java.util.ArrayList;
import java.util.List;
import org.dfra.app.raster.MissionResult.RobotMissionResult;
import org.dfra.app.raster.ModuleReadings.TeammateDistance;

/**
 * How far two robots were apart at an instant, from base to base: by their estimates, as one of
 * them told it, and truly.
 *
 * @param time seconds since the search began
 * @param estimated metres
 * @param actual metres
 */
public record RobotSeparation(double time, double estimated, double actual) {

  /** Samples farther apart say nothing of what was between, seconds. */
  private static final double WIDEST = 0.5;

  /** All that one robot told of another, where it is known where both truly were. */
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

  /** What the estimates are off by, root mean square, metres; NaN where there is none. */
  public static double rms(List<RobotSeparation> all) {
    double squares = 0;
    for (RobotSeparation each : all) {
      squares += (each.estimated - each.actual) * (each.estimated - each.actual);
    }
    return Math.sqrt(squares / all.size());
  }
}
