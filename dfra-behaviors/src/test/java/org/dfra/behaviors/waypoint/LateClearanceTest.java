package org.dfra.behaviors.waypoint;

import static org.assertj.core.api.Assertions.assertThat;
import static org.dfra.behaviors.ScriptedRobot.at;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.UUID;
import org.dfra.behavior.BehaviorStatus.Phase;
import org.dfra.behavior.LegGoal;
import org.dfra.behaviors.ScriptedRobot;
import org.dfra.behaviors.motor.FuzzyDriveImpl;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Robots that see each other late, as on a busy computer. */
@Timeout(60)
class LateClearanceTest {

  /** Wanted between two robots at any time, metres. */
  private static final double LEAST = 0.3;

  /** Between their bumpers at the beginning, metres. */
  private static final double INITIAL_GAP = 7;

  private static final double TICK = 0.1; // seconds
  private static final LegGoal TEN_METRES = new LegGoal(null, at(10, 0), 0.4);

  /** Straight on at full speed up to 0.8 m, and stop: easy to predict. */
  private static final String STOPS_AT_80_CM =
      """
      [System]
      Name='stops'
      Type='sugeno'
      NumInputs=4
      NumOutputs=2
      NumRules=2
      AndMethod='min'
      OrMethod='max'
      ImpMethod='min'
      AggMethod='max'
      DefuzzMethod='wtaver'

      [Input1]
      Name='left'
      Range=[0 8]
      NumMFs=1
      MF1='any':'trapmf',[-2 -1 9 10]

      [Input2]
      Name='centre'
      Range=[0 8]
      NumMFs=2
      MF1='close':'trapmf',[-2 -1 0.8 0.81]
      MF2='away':'trapmf',[0.8 0.81 9 10]

      [Input3]
      Name='right'
      Range=[0 8]
      NumMFs=1
      MF1='any':'trapmf',[-2 -1 9 10]

      [Input4]
      Name='heading_error'
      Range=[-180 180]
      NumMFs=1
      MF1='any':'trapmf',[-220 -200 200 220]

      [Output1]
      Name='tr'
      Range=[0 1]
      NumMFs=2
      MF1='stop':'constant',[0]
      MF2='fast':'constant',[1]

      [Output2]
      Name='rv'
      Range=[-1 1]
      NumMFs=1
      MF1='ahead':'constant',[0]

      [Rules]
      0 1 0 0, 1 1 (1) : 1
      0 2 0 0, 2 1 (1) : 1
      """;

  @TempDir Path folder;

  private final List<ScriptedRobot> robots = List.of(new ScriptedRobot(), new ScriptedRobot());

  @AfterEach
  void end() {
    robots.forEach(ScriptedRobot::close);
  }

  /**
   * Each drives to its own east, which is towards the other. Both stop at 0.8 m of what they see:
   * with 0.4 s of delay they would come 0.56 m nearer meanwhile, to less than 0.3 m.
   */
  @ParameterizedTest
  @ValueSource(ints = {1, 2, 4})
  void twoThatMeetKeepTheirClearanceThoughTheySeeEachOtherLate(int ticks) throws Exception {
    Path rules = Files.writeString(folder.resolve("stops.fis"), STOPS_AT_80_CM);
    for (ScriptedRobot robot : robots) {
      robot.ahead = INITIAL_GAP;
      robot.roomDelay = Duration.ofMillis(100L * ticks);
      begin(robot, rules);
    }
    List<Double> gaps = new ArrayList<>(List.of(INITIAL_GAP));
    for (int i = 0; i < 70; i++) {
      double seen = gaps.get(Math.max(0, gaps.size() - ticks));
      for (ScriptedRobot robot : robots) {
        robot.ahead = seen;
        robot.time.step(TICK);
      }
      gaps.add(INITIAL_GAP - robots.get(0).east - robots.get(1).east);
    }
    assertThat(gaps)
        .as("metres between them, %.1f s late", ticks * TICK)
        .allMatch(gap -> gap >= LEAST);
    assertThat(gaps.get(gaps.size() - 1)).as("where they stop").isLessThan(0.9);
    assertThat(robots).allMatch(robot -> robot.drive.turning.speed() == 0);
  }

  private static void begin(ScriptedRobot robot, Path rules) throws IOException {
    FuzzyDriveImpl unused =
        robot.add(
            new FuzzyDriveImpl(robot.context("stops", Map.of("system_file", rules.toString()))));
    UUID goal = robot.addGoTo(Map.of("fuzzy_drive", "stops")).pursue(TEN_METRES);
    assertThat(goal).isNotNull();
  }

  @Test
  void aRobotThatSeesLateComesToTheEndOfItsLineAllTheSame() throws Exception {
    ScriptedRobot robot = robots.get(0);
    robot.roomDelay = Duration.ofMillis(400);
    GoToWaypointImpl goTo = robot.addGoTo(Map.of());
    UUID unused = goTo.pursue(TEN_METRES);
    assertThat(robot.reaches(goTo, Phase.SUCCEEDED, 30)).as("%s", goTo.status()).isTrue();
  }
}
