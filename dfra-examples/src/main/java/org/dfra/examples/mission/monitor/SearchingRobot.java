package org.dfra.examples.mission.monitor;

import java.io.IOException;
import java.util.List;
import org.dfra.behavior.BehaviorStatus;
import org.dfra.behavior.GoToWaypoint;
import org.dfra.behavior.RasterSearch;
import org.dfra.behaviors.raster.RasterPlan;
import org.dfra.behaviors.raster.RasterPlan.Lane;
import org.dfra.directory.ModuleDirectory;
import org.dfra.examples.mission.RobotLog;
import org.dfra.geometry.LocalPosition;
import org.dfra.module.Parameter;

/**
 * A robot that searches.
 *
 * @param <R> its runtime
 * @param name the robot's
 * @param robot its runtime
 * @param search its goal's behavior
 * @param waypointDriver its waypoint controller
 * @param plan the lanes it drives
 * @param recorder its log
 * @param subscriptions to its modules
 */
public record SearchingRobot<R>(
    String name,
    R robot,
    RasterSearch search,
    GoToWaypoint waypointDriver,
    RasterPlan plan,
    RobotLog recorder,
    RobotSubscriptions subscriptions) {

  /** Rounding tolerance of a share. */
  private static final double ROUNDING = 1e-6;

  /**
   * Finds its modules and subscribes to them.
   *
   * @param <R> its runtime
   */
  public static <R> SearchingRobot<R> connect(
      String name, R robot, RasterPlan plan, ModuleDirectory directory) throws IOException {
    RobotLog log = new RobotLog(name, plan.region().frame());
    RasterSearch search = one(directory, log, RasterSearch.class);
    RobotSubscriptions hearing = new RobotSubscriptions(name, log, search.status());
    hearing.subscribe(directory);
    // The most recently discovered one: a proxy from before a process died may not recover.
    GoToWaypoint driver = directory.proxyFor(log.query(GoToWaypoint.class));
    return new SearchingRobot<>(name, robot, search, driver, plan, log, hearing);
  }

  private static <M extends org.dfra.module.Module> M one(
      ModuleDirectory directory, RobotLog log, Class<M> kind) throws IOException {
    return directory.find(log.query(kind)).stream()
        .findFirst()
        .orElseThrow(
            () ->
                new IOException("there is no " + log.query(kind) + "; add one to the robot's XML"))
        .module();
  }

  /** Whether its search was started and has ended, by the last received status. */
  public boolean hasEnded() {
    BehaviorStatus status = subscriptions.latestStatus();
    return status.goal() != null && !status.phase().isUnderWay(); // it has none until it begins
  }

  /** Waypoints that are done, by the last received status. */
  public int waypoints() {
    BehaviorStatus status = subscriptions.latestStatus();
    return (int) Math.floor(status.completion() * plan.waypoints().size() + ROUNDING);
  }

  /** Whether it is on a lane, and at least this many metres from both its ends. */
  public boolean isOnLane(LocalPosition at, double metres) {
    int done = waypoints();
    for (Lane lane : plan.lanes()) {
      if (lane.waypoint() + 1 == done) {
        return distance(lane.from(), at) > metres && distance(lane.to(), at) > metres;
      }
    }
    return false;
  }

  private static double distance(LocalPosition one, LocalPosition other) {
    return Math.hypot(one.east() - other.east(), one.north() - other.north());
  }

  /**
   * The 99th percentile of the lateness of its driver's last cycles, seconds of the robot's time.
   *
   * @throws IOException if it cannot be queried
   */
  double lateness() throws IOException {
    List<Parameter> parameters = waypointDriver.parameters();
    return parameters.stream()
        .filter(each -> each.name().equals("lateness_p99"))
        .mapToDouble(each -> Double.parseDouble(each.value()))
        .findFirst()
        .orElseThrow(
            () ->
                new IOException(
                    "the behaviour that drives " + name + " does not publish its lateness"));
  }
}
