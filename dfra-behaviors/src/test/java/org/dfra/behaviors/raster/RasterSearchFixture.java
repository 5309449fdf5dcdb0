package org.dfra.behaviors.raster;

import static org.dfra.behaviors.ScriptedRobot.at;

import java.util.List;
import java.util.Map;
import org.dfra.behavior.RasterGoal;
import org.dfra.behaviors.ScriptedRobot;
import org.dfra.behaviors.waypoint.FollowWaypointsImpl;
import org.dfra.behaviors.waypoint.GoToWaypointImpl;
import org.dfra.core.state.StateStore;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Timeout;

/** A robot that searches 6 m by 8 m in four lanes. */
@Timeout(120)
abstract class RasterSearchFixture {

  static final RasterGoal FIELD =
      new RasterGoal(List.of(at(1, 1), at(7, 1), at(7, 9), at(1, 9)), 2, 1.6, false);
  static final int WAYPOINTS = RasterPlan.of(FIELD).waypoints().size();
  static final double LONG = 300; // seconds

  final ScriptedRobot robot = new ScriptedRobot();
  GoToWaypointImpl goTo;
  FollowWaypointsImpl follow;

  @BeforeEach
  void begin() {
    goTo = robot.addGoTo(Map.of());
    follow = robot.add(new FollowWaypointsImpl(robot.context("follow_waypoints", Map.of())));
  }

  @AfterEach
  void end() {
    robot.close();
  }

  RasterSearchImpl addSearch(Map<String, String> parameters) {
    return robot.add(new RasterSearchImpl(robot.context("raster_search", parameters)));
  }

  /** Its group dies, and what drives its path with it; nothing is kept any more. */
  RasterSearchImpl crash(RasterSearchImpl search) throws Exception {
    byte[] kept = robot.states.get("raster_search").read("raster").orElseThrow();
    robot.end(search);
    robot.end(follow);
    follow = robot.add(new FollowWaypointsImpl(robot.context("follow_waypoints", Map.of())));
    robot.states.put("raster_search", StateStore.inMemory());
    robot.states.get("raster_search").write("raster", kept);
    return addSearch(Map.of());
  }
}
