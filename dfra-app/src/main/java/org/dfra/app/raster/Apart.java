package org.dfra.app.raster;

import java.util.ArrayList;
import java.util.List;
import org.dfra.app.raster.Flight.RobotFlight;
import org.dfra.app.raster.Overheard.Mate;

/**
 * How far two robots were apart at an instant, from base to base: by their estimates, as one of
 * them told it, and truly.
 *
 * @param time seconds since the search began
 * @param estimated metres
 * @param truly metres
 */
public record Apart(double time, double estimated, double truly) {

  /** Samples farther apart say nothing of what was between, seconds. */
  private static final double WIDEST = 0.5;

  /** All that one robot told of another, where it is known where both truly were. */
  public static List<Apart> all(RobotFlight teller, RobotFlight other) {
    List<Apart> all = new ArrayList<>();
    int moments = Math.min(teller.samples().size(), other.samples().size());
    int next = 1;
    for (Mate each : teller.overheard().mates()) {
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
      all.add(new Apart(each.time(), each.distance(), Math.hypot(east, north)));
    }
    return all;
  }

  /** What the estimates are off by, root mean square, metres; NaN where there is none. */
  public static double rms(List<Apart> all) {
    double squares = 0;
    for (Apart each : all) {
      squares += (each.estimated - each.truly) * (each.estimated - each.truly);
    }
    return Math.sqrt(squares / all.size());
  }
}
