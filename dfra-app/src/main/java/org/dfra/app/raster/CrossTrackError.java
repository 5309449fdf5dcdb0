package org.dfra.app.raster;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.dfra.behaviors.raster.Lane;
import org.dfra.behaviors.raster.RasterPlan;

/**
 * How far a robot was off its lane at one moment. Moments at which it was on no lane, or near the
 * ends of one, have none.
 *
 * @param time seconds since the search began
 * @param lane which one, in the order in which they are driven, from 1
 * @param estimated by its own estimate, metres, left of the lane is +
 * @param actual likewise; the estimate's where it truly was beyond the lane's ends
 */
public record CrossTrackError(double time, int lane, double estimated, double actual) {

  /** Metres of a lane's ends that do not count: there it turns in and out. */
  private static final double ENDS = 2;

  /** So much may a share be short of what it stands for. */
  private static final double ROUNDING = 1e-6;

  /** Of one moment. */
  public static Optional<CrossTrackError> of(Sample at, RasterPlan plan) {
    if (!at.isEstimated()) {
      return Optional.empty();
    }
    int done = waypoints(at, plan);
    for (int i = 0; i < plan.lanes().size(); i++) {
      Lane lane = plan.lanes().get(i);
      if (lane.waypoint() + 1 == done) { // its beginning is done, its end is next
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

  /** Of all moments that have one. */
  public static List<CrossTrackError> all(List<Sample> samples, RasterPlan plan) {
    List<CrossTrackError> all = new ArrayList<>();
    samples.forEach(each -> of(each, plan).ifPresent(all::add));
    return all;
  }

  /** How many of the plan's waypoints are done. */
  static int waypoints(Sample at, RasterPlan plan) {
    return (int) Math.floor(at.done() * plan.waypoints().size() + ROUNDING);
  }

  /** Off a lane, left is +; NaN beyond its ends or near them. */
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
