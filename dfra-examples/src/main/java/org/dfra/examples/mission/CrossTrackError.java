package org.dfra.examples.mission;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.dfra.behaviors.raster.RasterPlan;
import org.dfra.behaviors.raster.RasterPlan.Lane;
import org.dfra.examples.mission.RobotLog.Sample;

/**
 * A robot's cross-track error at one time. Samples off the lanes, or near the ends of one, have
 * none.
 *
 * @param time seconds since the search began
 * @param lane number of the lane, in the order in which they are driven, from 1
 * @param estimated by its own estimate, metres, left of the lane is +
 * @param actual likewise by ground truth; the estimate's if it was truly beyond the lane's ends
 */
public record CrossTrackError(double time, int lane, double estimated, double actual) {

  /** Excluded length at a lane's ends, metres: there the robot turns in and out. */
  private static final double ENDS = 2;

  /** Rounding tolerance of a share. */
  private static final double ROUNDING = 1e-6;

  /** The error of one sample. */
  public static Optional<CrossTrackError> of(Sample at, RasterPlan plan) {
    if (!at.isEstimated()) {
      return Optional.empty();
    }
    int done = waypoints(at, plan);
    for (int i = 0; i < plan.lanes().size(); i++) {
      Lane lane = plan.lanes().get(i);
      if (lane.waypoint() + 1 == done) { // its first waypoint is done, its last is next
        double estimated = signedDistance(lane, at.estimatedEast(), at.estimatedNorth());
        if (Double.isNaN(estimated)) {
          return Optional.empty();
        }
        double truly = signedDistance(lane, at.east(), at.north());
        return Optional.of(
            new CrossTrackError(
                at.time(), i + 1, estimated, Double.isNaN(truly) ? estimated : truly));
      }
    }
    return Optional.empty();
  }

  /** The errors of all samples that have one. */
  public static List<CrossTrackError> all(List<Sample> samples, RasterPlan plan) {
    List<CrossTrackError> all = new ArrayList<>();
    samples.forEach(each -> of(each, plan).ifPresent(all::add));
    return all;
  }

  /** Number of the plan's waypoints that are done. */
  static int waypoints(Sample at, RasterPlan plan) {
    return (int) Math.floor(at.done() * plan.waypoints().size() + ROUNDING);
  }

  /** Signed distance from a lane, left is +; NaN beyond its ends or near them. */
  private static double signedDistance(Lane lane, double east, double north) {
    double length = lane.length();
    double ux = (lane.to().east() - lane.from().east()) / length;
    double uy = (lane.to().north() - lane.from().north()) / length;
    double dx = east - lane.from().east();
    double dy = north - lane.from().north();
    double along = ux * dx + uy * dy;
    return along < ENDS || along > length - ENDS ? Double.NaN : ux * dy - uy * dx;
  }
}
