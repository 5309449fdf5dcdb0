package org.dfra.behaviors.raster;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.UUID;
import org.dfra.behavior.BehaviorStatus.Phase;
import org.dfra.behaviors.waypoint.FollowWaypointsImpl;
import org.dfra.core.state.StateStore;
import org.junit.jupiter.api.Test;

/** What a search does that an earlier process has begun. */
class RasterSearchRestartTest extends RasterSearchFixture {

  @Test
  void goesOnWhereItWasWhenItsProcessHasDied() throws Exception {
    RasterSearchImpl first = addSearch(Map.of());
    UUID unused = first.pursue(FIELD);
    assertThat(robot.reachesActivity(first, "lane 3 of ", LONG)).isTrue();
    double done = first.status().completion();
    assertThat(done).isPositive();
    RasterSearchImpl second = crash(first);
    assertThat(second.status().phase()).isEqualTo(Phase.RUNNING);
    assertThat(second.status().completion()).isEqualTo(done);
    assertThat(robot.reachesActivity(second, "lane 3 of ", 2)).as("%s", second.status()).isTrue();
    assertThat(robot.reaches(second, Phase.SUCCEEDED, LONG)).as("%s", second.status()).isTrue();
  }

  /** Its process dies, and what drives its path in another process does not notice. */
  private void dieAlone(RasterSearchImpl search) {
    robot.kill(search, "raster_search");
  }

  @Test
  void goesOnWithThePathThatItsDeadProcessBegan() throws Exception {
    RasterSearchImpl first = addSearch(Map.of());
    UUID unused = first.pursue(FIELD);
    assertThat(robot.reachesActivity(first, "lane 2 of ", LONG)).isTrue();
    UUID path = follow.status().goal();
    dieAlone(first);
    double done = follow.status().completion();
    assertThat(robot.time.until(() -> follow.status().completion() > done + 0.3, LONG))
        .as("it is driven on meanwhile")
        .isTrue();
    RasterSearchImpl second = addSearch(Map.of());
    robot.time.step(1);
    assertThat(second.status().phase()).isEqualTo(Phase.RUNNING);
    assertThat(second.status().completion()).isCloseTo(follow.status().completion(), within(0.2));
    assertThat(follow.status().goal()).isEqualTo(path);
    assertThat(robot.reaches(second, Phase.SUCCEEDED, LONG)).as("%s", second.status()).isTrue();
    assertThat(follow.status().goal()).as("no other was begun").isEqualTo(path);
    assertThat(follow.status().phase()).isEqualTo(Phase.SUCCEEDED);
  }

  @Test
  void doesNotDriveAgainWhatWasDrivenWhileItWasDead() throws Exception {
    RasterSearchImpl first = addSearch(Map.of());
    UUID unused = first.pursue(FIELD);
    assertThat(robot.reachesActivity(first, "lane 2 of ", LONG)).isTrue();
    UUID path = follow.status().goal();
    dieAlone(first);
    assertThat(robot.reaches(follow, Phase.SUCCEEDED, LONG)).isTrue();
    RasterSearchImpl second = addSearch(Map.of());
    assertThat(robot.reaches(second, Phase.SUCCEEDED, 2)).as("%s", second.status()).isTrue();
    assertThat(follow.status().goal()).isEqualTo(path);
  }

  @Test
  void waitsToBeResumedWhereItsPathWasGivenUpWhileItWasDead() throws Exception {
    RasterSearchImpl first = addSearch(Map.of());
    UUID unused = first.pursue(FIELD);
    assertThat(robot.reachesActivity(first, "lane 2 of ", LONG)).isTrue();
    dieAlone(first);
    Object stopped = robot.drive.emergencyStop("a test");
    assertThat(robot.reaches(follow, Phase.CANCELLED, 2)).as("%s", stopped).isTrue();
    Object released = robot.drive.releaseEmergencyStop("a test");
    RasterSearchImpl second = addSearch(Map.of());
    assertThat(robot.reaches(second, Phase.PAUSED, 2)).as("%s", released).isTrue();
    double stood = robot.north;
    robot.time.step(5);
    assertThat(robot.north).isEqualTo(stood);
    second.resume();
    assertThat(robot.reaches(second, Phase.SUCCEEDED, LONG)).as("%s", second.status()).isTrue();
  }

  @Test
  void knowsAfterItsDeathThatAStopCameAfterItWasAskedFor() throws Exception {
    robot.hide(robot.drive);
    RasterSearchImpl first = addSearch(Map.of());
    UUID unused = first.pursueUnattended(FIELD);
    robot.time.step(1);
    dieAlone(first);
    robot.setAhead("drive", Duration.ofHours(-1)); // no clock has a part in this
    Object stopped = robot.drive.emergencyStop("a test");
    Object released = robot.drive.releaseEmergencyStop("a test");
    robot.show(robot.drive);
    RasterSearchImpl second = addSearch(Map.of());
    assertThat(robot.reaches(second, Phase.PAUSED, 2))
        .as("%s %s %s", stopped, released, second.status())
        .isTrue();
  }

  /** In a new process the directory is empty at first. */
  private RasterSearchImpl startsBeforeItFindsItsPath() {
    robot.hide(follow);
    RasterSearchImpl search = addSearch(Map.of());
    robot.time.step(2);
    assertThat(search.status().activity()).contains("it needs a FollowWaypoints on atrv1");
    robot.show(follow);
    return search;
  }

  @Test
  void goesOnWithThePathOfItsDeadProcessThoughItFindsThatLate() throws Exception {
    RasterSearchImpl first = addSearch(Map.of());
    UUID unused = first.pursue(FIELD);
    assertThat(robot.reachesActivity(first, "lane 2 of ", LONG)).isTrue();
    UUID path = follow.status().goal();
    dieAlone(first);
    RasterSearchImpl second = startsBeforeItFindsItsPath();
    assertThat(robot.reaches(second, Phase.SUCCEEDED, LONG)).as("%s", second.status()).isTrue();
    assertThat(follow.status().goal()).as("no other was begun").isEqualTo(path);
    assertThat(follow.status().phase()).isEqualTo(Phase.SUCCEEDED);
  }

  @Test
  void beginsNoPathThatSomebodyPausedOrCancelledBeforeItFindsThat() throws Exception {
    RasterSearchImpl search = addSearch(Map.of());
    UUID unused = search.pursue(FIELD);
    assertThat(robot.reachesActivity(search, "lane 2 of ", LONG)).isTrue();
    for (boolean isPaused : List.of(true, false)) {
      dieAlone(search);
      if (isPaused) {
        follow.pause();
      } else {
        follow.cancel();
      }
      search = startsBeforeItFindsItsPath();
      assertThat(robot.reaches(search, Phase.PAUSED, 2)).as("%s", search.status()).isTrue();
      double stood = robot.north;
      robot.time.step(5);
      assertThat(robot.north).isEqualTo(stood);
      search.resume();
      assertThat(robot.reachesActivity(search, "waypoint ", 2)).as("%s", search.status()).isTrue();
    }
  }

  @Test
  void endsThePathOfItsDeadProcessWhereItIsToWait() throws Exception {
    RasterSearchImpl first = addSearch(Map.of());
    UUID unused = first.pursue(FIELD);
    assertThat(robot.reachesActivity(first, "lane 2 of ", LONG)).isTrue();
    dieAlone(first);
    RasterSearchImpl second = addSearch(Map.of("resume_after_crash", "false"));
    assertThat(second.status().phase()).isEqualTo(Phase.PAUSED);
    assertThat(follow.status().phase()).isEqualTo(Phase.CANCELLED);
    second.resume();
    assertThat(robot.reaches(second, Phase.SUCCEEDED, LONG)).as("%s", second.status()).isTrue();
  }

  @Test
  void goesOnBeforeItsNeighboursAreThere() throws Exception {
    RasterSearchImpl first = addSearch(Map.of());
    UUID unused = first.pursue(FIELD);
    assertThat(robot.reachesActivity(first, "lane 2 of ", LONG)).isTrue();
    robot.end(follow);
    byte[] kept = robot.states.get("raster_search").read("raster").orElseThrow();
    robot.end(first);
    robot.states.get("raster_search").write("raster", kept);
    RasterSearchImpl second = addSearch(Map.of());
    robot.time.step(3);
    assertThat(second.status().activity()).contains("it needs a FollowWaypoints on atrv1");
    follow = robot.add(new FollowWaypointsImpl(robot.context("follow_again", Map.of())));
    assertThat(robot.reaches(second, Phase.SUCCEEDED, LONG)).as("%s", second.status()).isTrue();
  }

  @Test
  void waitsToBeResumedAfterAnOrderlyEndOrWhereConfiguredTo() throws Exception {
    RasterSearchImpl first = addSearch(Map.of());
    UUID unused = first.pursue(FIELD);
    assertThat(robot.reachesActivity(first, "lane 2 of ", LONG)).isTrue();
    robot.end(first);
    RasterSearchImpl second = addSearch(Map.of());
    assertThat(second.status().phase()).isEqualTo(Phase.PAUSED);
    double stood = robot.north;
    robot.time.step(5);
    assertThat(robot.north).isEqualTo(stood);
    second.resume();
    assertThat(robot.reachesActivity(second, "lane 2 of ", 2)).isTrue();

    byte[] kept = robot.states.get("raster_search").read("raster").orElseThrow();
    robot.end(second);
    robot.states.get("raster_search").write("raster", kept);
    RasterSearchImpl third = addSearch(Map.of("resume_after_crash", "false"));
    assertThat(third.status().phase()).isEqualTo(Phase.PAUSED);
    third.resume();
    assertThat(robot.reaches(third, Phase.SUCCEEDED, LONG)).as("%s", third.status()).isTrue();
  }

  @Test
  void doesNotGoOnWithWhatIsCancelled() throws Exception {
    RasterSearchImpl search = addSearch(Map.of());
    UUID unused = search.pursue(FIELD);
    assertThat(robot.reachesActivity(search, "lane 2 of ", LONG)).isTrue();
    search.cancel();
    assertThat(follow.status().phase()).isEqualTo(Phase.CANCELLED);
    robot.end(search);
    assertThat(addSearch(Map.of()).status().phase()).isEqualTo(Phase.CANCELLED);
  }

  @Test
  void beginsAfreshWhereWhatWasKeptIsGarbled() throws Exception {
    String whole =
        "region=48.0,11.0 48.0,11.0001 48.0001,11.0001\nswath=2\nspacing=1.6\nreversed=false\n"
            + "reached=1\nphase=RUNNING\n";
    for (String kept :
        List.of(
            "\u0000\u00ff",
            "region=48.0,11.0 x\nreached=1",
            "region=\\u00",
            whole.replace("reached=1", "reached=-4"),
            whole.replace("RUNNING", "SUCCEEDED"),
            whole.replace("RUNNING", "DANCING"),
            whole.replace("swath=2\n", ""),
            whole + "path=x\npath-reached=0\npath-missed=0\n",
            whole + "path=00000000-0000-0000-0000-000000000001\npath-reached=0\n",
            whole + "stopped=yesterday\n",
            whole + "asked-at=yesterday\n",
            whole.replace("48.0001,11.0001", "NaN,11"),
            whole.replace("48.0,11.0001", "48.0,11.0"))) {
      robot.states.put("raster_search", StateStore.inMemory());
      robot.states.get("raster_search").write("raster", kept.getBytes(UTF_8));
      RasterSearchImpl search = addSearch(Map.of());
      assertThat(search.status().phase()).as(kept).isEqualTo(Phase.IDLE);
      robot.end(search);
    }
    robot
        .states
        .get("raster_search")
        .write("raster", whole.replace("=1\n", "=99\n").getBytes(UTF_8));
    RasterSearchImpl search = addSearch(Map.of());
    assertThat(search.status().phase())
        .as("more than all: the last again")
        .isEqualTo(Phase.RUNNING);
  }
}
