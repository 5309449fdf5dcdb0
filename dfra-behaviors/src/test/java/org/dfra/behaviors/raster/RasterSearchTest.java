package org.dfra.behaviors.raster;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.dfra.behaviors.ScriptedRobot.at;

import java.util.List;
import java.util.Map;
import java.util.UUID;
import org.dfra.behavior.BehaviorStatus.Phase;
import org.dfra.behavior.GoalRefusedException;
import org.dfra.behavior.RasterGoal;
import org.junit.jupiter.api.Test;

/** What a search does in one process. */
class RasterSearchTest extends RasterSearchFixture {

  @Test
  void searchesTheRegionLaneByLane() throws Exception {
    RasterSearchImpl search = addSearch(Map.of());
    UUID goal = search.pursue(FIELD);
    assertThat(robot.reachesActivity(search, "lane 2 of ", LONG)).isTrue();
    assertThat(robot.reaches(search, Phase.SUCCEEDED, LONG)).as("%s", search.status()).isTrue();
    assertThat(search.status().goal()).isEqualTo(goal);
    assertThat(search.status().activity())
        .isEqualTo("the region is searched: it has reached all waypoints");
    assertThat(goTo.status().phase()).isEqualTo(Phase.SUCCEEDED);
    robot.end(search);
    RasterSearchImpl next = addSearch(Map.of());
    assertThat(next.status().phase()).as("what has ended is not begun").isEqualTo(Phase.SUCCEEDED);
  }

  @Test
  void remembersWhatItSkippedThoughItsPathRestarts() throws Exception {
    giveUpAtOnce();
    RasterSearchImpl first = addSearch(Map.of());
    UUID unused = first.pursue(FIELD);
    assertThat(robot.reachesActivity(first, "waypoint 3 of ", LONG)).isTrue();
    robot.isHeld = true;
    assertThat(robot.time.until(() -> first.status().skippedParts() == 1, LONG)).isTrue();
    robot.isHeld = false;
    first.pause();
    first.resume();
    assertThat(robot.reachesActivity(first, "waypoint 5 of " + WAYPOINTS, LONG))
        .as("counted through the whole search: %s", first.status())
        .isTrue();
    assertThat(first.status().skippedParts()).isEqualTo(1);
    assertThat(first.status().completedParts()).isEqualTo(4);
    assertThat(first.status().totalParts()).isEqualTo(WAYPOINTS);
    RasterSearchImpl second = crash(first);
    assertThat(second.status().skippedParts()).isEqualTo(1);
    assertThat(second.status().completedParts()).isEqualTo(4);
    assertThat(second.status().totalParts()).isEqualTo(WAYPOINTS);
    assertThat(robot.reaches(second, Phase.SUCCEEDED, LONG)).as("%s", second.status()).isTrue();
    assertThat(second.status().skippedParts()).isEqualTo(1);
    assertThat(second.status().activity())
        .isEqualTo(
            "the region is searched: 1 of "
                + WAYPOINTS
                + " waypoints skipped, since they could not be reached");
  }

  @Test
  void isSearchedThoughTheLastThatWasLeftIsBarred() throws Exception {
    giveUpAtOnce();
    RasterSearchImpl search = addSearch(Map.of());
    UUID unused = search.pursue(FIELD);
    assertThat(robot.reachesActivity(search, "waypoint " + WAYPOINTS + " of ", LONG)).isTrue();
    search.pause();
    robot.isHeld = true;
    search.resume();
    assertThat(robot.reaches(search, Phase.SUCCEEDED, LONG)).as("%s", search.status()).isTrue();
    assertThat(search.status().skippedParts()).isEqualTo(1);
    assertThat(search.status().activity()).contains("1 of " + WAYPOINTS);
  }

  @Test
  void failsWhereItCanGetToNone() throws Exception {
    giveUpAtOnce();
    robot.isHeld = true;
    RasterSearchImpl search = addSearch(Map.of());
    UUID unused = search.pursue(FIELD);
    assertThat(robot.reaches(search, Phase.FAILED, LONG)).as("%s", search.status()).isTrue();
    assertThat(search.status().skippedParts()).isEqualTo(WAYPOINTS);
    assertThat(search.status().activity()).isEqualTo("it could reach none of its waypoints");
  }

  private void giveUpAtOnce() {
    robot.end(goTo);
    goTo = robot.addGoTo(Map.of("max_recoveries", "0"));
  }

  @Test
  void pausesAndKeepsWhatItHasAtAnEmergencyStop() throws Exception {
    RasterSearchImpl search = addSearch(Map.of());
    UUID goal = search.pursue(FIELD);
    assertThat(robot.reachesActivity(search, "lane 2 of ", LONG)).isTrue();
    Object stopped = robot.drive.emergencyStop("a test");
    assertThat(robot.reaches(search, Phase.PAUSED, 2)).as("%s", stopped).isTrue();
    assertThat(search.status().activity())
        .startsWith("its path was cancelled: its leg was cancelled: atrv1/drive is stopped");
    Object released = robot.drive.releaseEmergencyStop("a test");
    double stood = robot.north;
    robot.time.step(5);
    assertThat(robot.north).as("%s", released).isEqualTo(stood);
    search.resume();
    assertThat(robot.reaches(search, Phase.SUCCEEDED, LONG)).as("%s", search.status()).isTrue();
    assertThat(search.status().goal()).isEqualTo(goal);
  }

  @Test
  void refusesARegionThatIsNoneBeforeAnythingMoves() {
    RasterSearchImpl search = addSearch(Map.of());
    RasterGoal crossed =
        new RasterGoal(List.of(at(1, 1), at(7, 9), at(7, 1), at(1, 9)), 2, 1.6, false);
    assertThatThrownBy(() -> search.pursue(crossed)).isInstanceOf(GoalRefusedException.class);
    assertThat(search.status().phase()).isEqualTo(Phase.IDLE);
    assertThatThrownBy(() -> addSearch(Map.of("resume_after_crash", "perhaps")))
        .hasMessage(
            "code: atrv1/raster_search: parameter resume_after_crash is \"perhaps\", which is not true or"
                + " false");
    assertThat(robot.drive.velocities).isEmpty();
  }

  private static RasterGoal onAnotherContinent() {
    return new RasterGoal(
        List.of(at(1e6, 1), at(1e6 + 6, 1), at(1e6 + 6, 9), at(1e6, 9)), 2, 1.6, false);
  }

  @Test
  void refusesARegionOnAnotherContinent() throws Exception {
    RasterSearchImpl search = addSearch(Map.of());
    assertThatThrownBy(() -> search.pursue(onAnotherContinent()))
        .isInstanceOf(GoalRefusedException.class)
        .hasMessageContaining(" km from the robot at ");
    assertThat(search.status().phase()).isEqualTo(Phase.IDLE);
    robot.end(search);
    RasterSearchImpl cautious = addSearch(Map.of("max_waypoint_distance", "5"));
    assertThatThrownBy(
            () ->
                cautious.pursue(
                    new RasterGoal(List.of(at(9, 1), at(19, 1), at(19, 9)), 2, 1.6, false)))
        .hasMessageContaining("farther than 5.0 m");
    assertThat(robot.drive.velocities).isEmpty();
  }

  @Test
  void failsBeforeAnythingMovesWhereItDoesNotKnowYetHowFarTheRegionIs() throws Exception {
    RasterSearchImpl search = addSearch(Map.of("position", "elsewhere"));
    UUID unused = search.pursue(onAnotherContinent());
    assertThat(robot.reaches(search, Phase.FAILED, 2)).as("%s", search.status()).isTrue();
    assertThat(search.status().activity()).contains("km from the robot at");
    assertThat(robot.drive.velocities).isEmpty();
  }
}
