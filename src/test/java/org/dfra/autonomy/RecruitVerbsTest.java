package org.dfra.autonomy;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.UUID;
import java.util.concurrent.atomic.AtomicReference;
import org.dfra.agent.RecruitmentAgent;
import org.dfra.app.InProcessCommand;
import org.dfra.behavior.BehaviorStatus.Phase;
import org.dfra.behavior.GoToWaypoint;
import org.dfra.behavior.LegGoal;
import org.dfra.flow.effector.DriveEffector;
import org.dfra.module.NotReadyException;
import org.dfra.report.terminal.ExitCode;
import org.dfra.testing.EmbeddedReggie;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.extension.RegisterExtension;
import org.junit.jupiter.api.io.TempDir;

/** {@code ./dfra recruit status} and {@code ./dfra recruit resume} with two robots. */
@Timeout(240)
class RecruitVerbsTest {

  private static final Duration PATIENCE = Duration.ofSeconds(60);

  @RegisterExtension static final EmbeddedReggie REGGIE = new EmbeddedReggie();

  @TempDir static Path folder;

  private static ServedRobots robots;
  private static RecruitmentAgent agent;

  @BeforeAll
  static void begin() throws Exception {
    robots = new ServedRobots(folder, REGGIE, PATIENCE);
    robots.serveSmallRobot();
    robots.serve("agent", "recruitment-agent", Map.of("percepts", "mine"));
    robots.serve("uav", "agent", "recruitment-agent", Map.of());
    agent = (RecruitmentAgent) robots.find("RecruitmentAgent on robot").module();
    RecruitmentAgent other = (RecruitmentAgent) robots.find("RecruitmentAgent on uav").module();
    assertThat(agent.awaitReadiness(PATIENCE).serves()).isTrue();
    assertThat(other.awaitReadiness(PATIENCE).serves()).isTrue();
  }

  @AfterAll
  static void end() {
    robots.close();
  }

  private static JsonNode json(InProcessCommand outcome) throws Exception {
    return new ObjectMapper().readTree(outcome.out());
  }

  private static InProcessCommand recruit(String... args) {
    List<String> all = new ArrayList<>(List.of("recruit"));
    all.addAll(List.of(args));
    return InProcessCommand.at(REGGIE, folder.resolve("state"), all);
  }

  private static void awaitHeld(String why) {
    await()
        .atMost(PATIENCE)
        .until(() -> String.valueOf(agent.status().holdReason()), held -> held.contains(why));
  }

  @Test
  void statusShowsEachRobotOrThoseThatAreNamed() throws Exception {
    InProcessCommand all = recruit("status");
    assertThat(all.code()).as(all.err()).isEqualTo(ExitCode.SUCCESS);
    assertThat(all.out().lines().findFirst().orElseThrow().split("\\s+"))
        .containsExactly("ROBOT", "HELPS", "STATE", "ACTIVITY");
    assertThat(all.out()).containsPattern("(?m)^robot  ").containsPattern("(?m)^uav  ");
    assertThat(all.err()).isEmpty();
    InProcessCommand one = recruit("status", "uav", "--json");
    assertThat(one.code()).isEqualTo(ExitCode.SUCCESS);
    assertThat(json(one)).hasSize(1);
    assertThat(json(one).get(0).get("robot").asText()).isEqualTo("uav");
    assertThat(json(one).get(0).get("responder").asText()).isEqualToIgnoringCase("free");
    assertThat(json(one).get(0).get("activity").asText()).isEqualTo("it is not helping");
  }

  @Test
  void aMissingRobotIsReportedInOneSentenceAndNoOtherIsResumed() {
    for (String verb : List.of("status", "resume")) {
      InProcessCommand outcome = recruit(verb, "uav", "ugv7", "--wait=2");
      assertThat(outcome.code()).isEqualTo(ExitCode.NOT_FOUND);
      assertThat(outcome.err())
          .isEqualTo(
              "dfra: robot ugv7 has no recruitment agent, or is not there; ./dfra persona list"
                  + " shows the robots"
                  + System.lineSeparator());
      assertThat(outcome.out()).isEmpty();
    }
  }

  @Test
  void resumeLeavesARobotAloneThatIsNotHeld() throws Exception {
    InProcessCommand outcome = recruit("resume", "uav", "--json");
    assertThat(outcome.code()).as(outcome.err()).isEqualTo(ExitCode.SUCCESS);
    assertThat(json(outcome)).hasSize(1);
    assertThat(json(outcome).get(0).path("held").asText("")).isIn("", "null");
    assertThat(outcome.err()).isEmpty();
  }

  /** A person pauses its leg; then it is stopped for an emergency. */
  @Test
  void aHeldRobotIsShownAndHelpsAgainWhenAPersonSaysSo() throws Exception {
    GoToWaypoint driving = (GoToWaypoint) robots.find("GoToWaypoint on robot").module();
    assertThat(driving.awaitReadiness(PATIENCE).serves()).isTrue();
    // The robot may not know yet where it is.
    AtomicReference<UUID> begun = new AtomicReference<>();
    await()
        .atMost(PATIENCE)
        .ignoreException(NotReadyException.class)
        .until(
            () -> {
              begun.set(driving.pursue(new LegGoal(null, SmallRobot.at(30, 0), 1)));
              return true;
            });
    UUID goal = begun.get();
    driving.pause();
    awaitHeld("stopped robot/go_to_waypoint");
    InProcessCommand held = recruit("status");
    assertThat(held.code()).as("asking is no failure").isEqualTo(ExitCode.SUCCESS);
    assertThat(held.out())
        .containsPattern("(?m)^robot +- +HELD +answers no call:")
        .doesNotContainPattern("(?m)^uav .*HELD");

    InProcessCommand resumed = recruit("resume", "robot");
    assertThat(resumed.code()).as(resumed.err()).isEqualTo(ExitCode.SUCCESS);
    assertThat(resumed.out()).containsPattern("(?m)^robot +- +free ").doesNotContain("HELD");
    assertThat(agent.status().holdReason()).isNull();
    assertThat(driving.status().phase()).as("nothing moves by this").isEqualTo(Phase.PAUSED);
    driving.cancel(goal);
    awaitHeld("stopped robot/go_to_waypoint");

    DriveEffector drive = (DriveEffector) robots.find("DriveEffector on robot").module();
    assertThat(drive.emergencyStop("a test").latched()).isTrue();
    awaitHeld("robot/drive is stopped for an emergency");
    InProcessCommand inVain = recruit("resume", "robot", "uav");
    assertThat(inVain.code()).as("it is held nevertheless").isEqualTo(ExitCode.FAILED);
    assertThat(inVain.out()).containsPattern("(?m)^robot +- +HELD ").containsPattern("(?m)^uav ");

    drive.releaseEmergencyStop("a test");
    awaitHeld("and released at");
    InProcessCommand last = recruit("resume", "robot", "--json");
    assertThat(last.code()).as(last.out()).isEqualTo(ExitCode.SUCCESS);
    assertThat(agent.status().holdReason()).isNull();
  }
}
