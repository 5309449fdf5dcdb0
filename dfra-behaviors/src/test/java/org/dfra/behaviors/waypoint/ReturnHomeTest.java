package org.dfra.behaviors.waypoint;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.dfra.behaviors.ScriptedRobot.at;

import java.util.List;
import java.util.Map;
import java.util.UUID;
import org.dfra.behavior.BehaviorStatus.Phase;
import org.dfra.behavior.GoalRefusedException;
import org.dfra.behavior.HomeGoal;
import org.dfra.behaviors.ScriptedRobot;
import org.dfra.module.Parameter;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

@Timeout(60)
class ReturnHomeTest {

  private final ScriptedRobot robot = new ScriptedRobot();

  @AfterEach
  void end() {
    robot.close();
  }

  private ReturnHomeImpl addReturn(Map<String, String> parameters) {
    return robot.add(new ReturnHomeImpl(robot.context("return_home", parameters)));
  }

  private static String home(ReturnHomeImpl module) {
    List<Parameter> all = module.parameters();
    return all.stream().filter(each -> each.name().equals("home")).findFirst().get().value();
  }

  private void move(double east, double north) {
    robot.east = east;
    robot.north = north;
    robot.time.step(0.3);
  }

  @Test
  void drivesToWhereTheRobotFirstKnewItsPosition() throws Exception {
    GoToWaypointImpl goTo = robot.addGoTo(Map.of());
    ReturnHomeImpl back = addReturn(Map.of());
    robot.time.step(0.3);
    move(8, 5);
    UUID unused = back.pursue(new HomeGoal(0.4));
    assertThat(robot.reaches(back, Phase.SUCCEEDED, 90)).as("%s", goTo.status()).isTrue();
    assertThat(robot.distanceTo(0, 0)).isLessThanOrEqualTo(0.4);
  }

  @Test
  void keepsHomeOverARestart() throws Exception {
    ReturnHomeImpl first = addReturn(Map.of());
    robot.time.step(0.3);
    String home = home(first);
    assertThat(home).isEqualTo("48.00000000 11.00000000");
    robot.end(first);
    move(8, 5);
    ReturnHomeImpl second = addReturn(Map.of());
    robot.time.step(0.3);
    assertThat(home(second)).isEqualTo(home);
  }

  @Test
  void takesAHomeThatIsWrittenOrSetAndKeepsWhatWasSet() throws Exception {
    ReturnHomeImpl first = addReturn(Map.of("home", "48.0001 11.0002"));
    robot.time.step(0.3);
    assertThat(home(first)).isEqualTo("48.00010000 11.00020000");
    move(8, 5);
    first.setParameter("home", "here");
    assertThat(home(first)).isNotEqualTo("48.00010000 11.00020000");
    first.setParameter("home", "48.0003, 11.0004");
    robot.end(first);
    assertThat(home(addReturn(Map.of()))).isEqualTo("48.00030000 11.00040000");
  }

  @Test
  void refusesWhatIsNoPlace() {
    assertThatThrownBy(() -> addReturn(Map.of("home", "Karlsruhe")))
        .hasMessage(
            "code: atrv1/return_home: parameter home is \"Karlsruhe\", which is not latitude and"
                + " longitude in degrees, such as 48.0001 11.0002, or here");
    ReturnHomeImpl back = addReturn(Map.of());
    for (String text : List.of("48", "48 eleven", "91 11", "NaN NaN", "")) {
      assertThatThrownBy(() -> back.setParameter("home", text))
          .as(text)
          .isInstanceOf(IllegalArgumentException.class)
          .hasMessageContaining("which is not latitude and longitude in degrees");
    }
  }

  @Test
  void waitsForAGoodPositionAndSaysSo() {
    robot.seesPlace = false;
    robot.time.step(1);
    GoToWaypointImpl goTo = robot.addGoTo(Map.of());
    ReturnHomeImpl back = addReturn(Map.of());
    assertThatThrownBy(() -> back.pursue(new HomeGoal(0.4)))
        .as("%s", goTo)
        .isInstanceOf(GoalRefusedException.class)
        .hasMessageContaining("has no home yet");
    assertThatThrownBy(() -> back.setParameter("home", "here"))
        .hasMessageEndingWith(
            "parameter home cannot be \"here\", which is not known yet; wait for the robot's"
                + " position");
  }

  @Test
  void findsHomeAgainWhereTheStoredOneIsCorrupt() throws Exception {
    ReturnHomeImpl first = addReturn(Map.of());
    robot.end(first);
    robot.states.get("return_home").write("home", "48.0 \u0000\u00ff".getBytes(UTF_8));
    move(8, 5);
    ReturnHomeImpl second = addReturn(Map.of());
    robot.time.step(0.3);
    assertThat(home(second)).startsWith("48.00004");
    assertThat(second.history().recent()).asString().contains("latitude and longitude");
    assertThat(at(8, 5).groundDistance(at(8, 5))).isZero();
  }
}
