package org.dfra.app.raster.monitor;

import java.io.IOException;
import java.util.List;
import org.dfra.app.raster.RobotLog;
import org.dfra.behavior.BehaviorStatus;
import org.dfra.behavior.GoToWaypoint;
import org.dfra.behavior.RasterSearch;
import org.dfra.behaviors.raster.Lane;
import org.dfra.behaviors.raster.RasterPlan;
import org.dfra.directory.ModuleDirectory;
import org.dfra.geometry.LocalPosition;
import org.dfra.module.Parameter;

/**
 * A robot that searches.
 *
 * @param <R> what runs it
 * @param name the robot's
 * @param robot what runs it
 * @param search what it was told to do
 * @param waypointDriver what it drives by
 * @param plan the lanes it drives
 * @param recorder what is noted of it
 * @param subscriptions what it tells
 */
public record SearchingRobot<R>(
    String name,
    R robot,
    RasterSearch search,
    GoToWaypoint waypointDriver,
    RasterPlan plan,
    RobotLog recorder,
    RobotSubscriptions subscriptions) {

  /** So much may a share be short of what it stands for. */
  private static final double ROUNDING = 1e-6;

  /**
   * Finds its modules and listens to them.
   *
   * @param <R> what runs it
   */
  public static <R> SearchingRobot<R> connect(
      String name, R robot, RasterPlan plan, ModuleDirectory directory) throws IOException {
    RobotLog log = new RobotLog(name, plan.region().frame());
    RasterSearch search = one(directory, log, RasterSearch.class);
    RobotSubscriptions hearing = new RobotSubscriptions(name, log, search.status());
    hearing.subscribe(directory);
    // Whichever is known last: what was found before a process died may not find its way back.
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

  /** Whether its search was begun and is over, by what was heard last. */
  public boolean hasEnded() {
    BehaviorStatus status = subscriptions.latestStatus();
    return status.goal() != null && !status.phase().isUnderWay(); // it has none until it begins
  }

  /** Waypoints that are done, by what was heard last. */
  public int waypoints() {
    BehaviorStatus status = subscriptions.latestStatus();
    return (int) Math.floor(status.completion() * plan.waypoints().size() + ROUNDING);
  }

  /** Whether it is on a lane, and so many metres from both its ends. */
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
   * Seconds of the robot's time that 99 % of its driver's last turns were late at the most.
   *
   * @throws IOException if it cannot be asked
   */
  double lateness() throws IOException {
    List<Parameter> parameters = waypointDriver.parameters();
    return parameters.stream()
        .filter(each -> each.name().equals("lateness_p99"))
        .mapToDouble(each -> Double.parseDouble(each.value()))
        .findFirst()
        .orElseThrow(() -> new IOException("what drives " + name + " does not tell its lateness"));
  }
}
