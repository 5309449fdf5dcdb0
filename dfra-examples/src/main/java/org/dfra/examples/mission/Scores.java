package org.dfra.examples.mission;

import java.util.Arrays;
import java.util.List;
import java.util.function.ToDoubleFunction;
import org.dfra.behaviors.raster.CoverageMap;
import org.dfra.behaviors.raster.RasterPlan;
import org.dfra.behaviors.raster.RasterPlan.Coverage;
import org.dfra.examples.mission.MissionResult.RobotMissionResult;
import org.dfra.examples.mission.RobotLog.Sample;
import org.dfra.geometry.LocalPosition;

/**
 * Metrics of one robot's search.
 *
 * @param completed whether it completed its lanes
 * @param seconds its duration
 * @param length distance driven, metres
 * @param plannedLength length of its lanes and the paths between them, metres
 * @param coverage share of the region that it truly passed within half a swath, 0 to 1
 * @param overlap share that it saw more than once
 * @param crossTrack error by its own estimate, on the lanes only
 * @param trueCrossTrack the same, by ground truth
 * @param waypointErrors minimum true distance to each waypoint that it did
 * @param estimateError root mean square between estimate and truth, metres
 * @param fixError root mean square between the last fix and the truth, metres
 * @param clearance minimum clearance to an obstacle or robot, metres
 */
public record Scores(
    boolean completed,
    double seconds,
    double length,
    double plannedLength,
    double coverage,
    double overlap,
    Scores.Deviation crossTrack,
    Scores.Deviation trueCrossTrack,
    Scores.Deviation waypointErrors,
    double estimateError,
    double fixError,
    double clearance) {

  /** Metrics of a robot's result over its plan. */
  public static Scores of(RobotMissionResult flight, RasterPlan plan) {
    List<Sample> samples = flight.samples();
    Coverage coverage = plan.coverage(trajectory(samples), plan.swath());
    List<CrossTrackError> off = CrossTrackError.all(samples, plan);
    List<Sample> estimated =
        samples.stream()
            .filter(each -> each.isEstimated() && !Double.isNaN(each.fixEast()))
            .toList();
    return new Scores(
        flight.completed(),
        samples.isEmpty() ? 0 : samples.get(samples.size() - 1).time(),
        length(samples),
        plan.length(),
        coverage.share(),
        coverage.overlap(),
        Deviation.of(numbers(off, CrossTrackError::estimated)),
        Deviation.of(numbers(off, CrossTrackError::actual)),
        Deviation.of(waypointErrors(samples, plan)),
        Deviation.of(
                numbers(
                    estimated,
                    s -> Math.hypot(s.estimatedEast() - s.east(), s.estimatedNorth() - s.north())))
            .rms(),
        Deviation.of(
                numbers(
                    estimated, s -> Math.hypot(s.fixEast() - s.east(), s.fixNorth() - s.north())))
            .rms(),
        samples.stream().mapToDouble(Sample::clearance).min().orElse(Double.POSITIVE_INFINITY));
  }

  /** Share of the region that at least one of the robots saw, 0 to 1. */
  public static double teamCoverage(MissionResult flight, Scenario scenario) {
    RasterPlan plan = scenario.plan();
    return flight.robots().stream()
        .map(each -> plan.coverageMap(trajectory(each.samples()), plan.swath()))
        .reduce(CoverageMap::and)
        .map(CoverageMap::share)
        .orElse(0.0);
  }

  /** The robot's true path, in the region's frame. */
  public static List<LocalPosition> trajectory(List<Sample> samples) {
    return samples.stream().map(each -> new LocalPosition(each.east(), each.north(), 0)).toList();
  }

  private static double length(List<Sample> samples) {
    double length = 0;
    for (int i = 1; i < samples.size(); i++) {
      Sample from = samples.get(i - 1);
      Sample to = samples.get(i);
      length += Math.hypot(to.east() - from.east(), to.north() - from.north());
    }
    return length;
  }

  /**
   * Minimum distance to each waypoint that the robot did, while that was the next one; for a
   * waypoint that it gave up, the distance that it reached.
   */
  private static double[] waypointErrors(List<Sample> samples, RasterPlan plan) {
    double[] least = new double[plan.waypoints().size()];
    Arrays.fill(least, Double.NaN);
    int next = 0;
    for (Sample each : samples) {
      int done = Math.min(CrossTrackError.waypoints(each, plan), least.length);
      for (int i = next; i <= Math.min(done, least.length - 1); i++) {
        LocalPosition waypoint = plan.path().get(i);
        double distance =
            Math.hypot(each.east() - waypoint.east(), each.north() - waypoint.north());
        least[i] = Double.isNaN(least[i]) ? distance : Math.min(least[i], distance);
      }
      next = Math.max(next, done);
    }
    return Arrays.copyOf(least, next);
  }

  private static <T> double[] numbers(List<T> all, ToDoubleFunction<T> number) {
    return all.stream().mapToDouble(number).toArray();
  }

  /**
   * Statistics of distances; NaN if there were none.
   *
   * @param mean of the distances, metres
   * @param rms root mean square, metres
   * @param within95 95th percentile, metres
   * @param most maximum, metres
   */
  public record Deviation(double mean, double rms, double within95, double most) {

    private static final double MOST_OF_THEM = 0.95;

    /** Statistics of distances in metres; their signs are ignored. */
    public static Deviation of(double... distances) {
      if (distances.length == 0) {
        return new Deviation(Double.NaN, Double.NaN, Double.NaN, Double.NaN);
      }
      double[] sorted = Arrays.stream(distances).map(Math::abs).sorted().toArray();
      double squares = Arrays.stream(sorted).map(each -> each * each).sum();
      int rank = (int) Math.ceil(MOST_OF_THEM * sorted.length); // the nearest-rank percentile
      return new Deviation(
          Arrays.stream(sorted).average().orElse(Double.NaN),
          Math.sqrt(squares / sorted.length),
          sorted[rank - 1],
          sorted[sorted.length - 1]);
    }
  }
}
