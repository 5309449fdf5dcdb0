package org.dfra.examples.recruit;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Instant;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.dfra.agent.RecruitmentStatus;
import org.dfra.agent.RequesterPhase;
import org.dfra.agent.ResponderPhase;
import org.dfra.behavior.BehaviorStatus;
import org.dfra.behavior.BehaviorStatus.Phase;
import org.dfra.examples.recruit.Snapshot.Availability;
import org.dfra.examples.recruit.Snapshot.Robot;
import org.dfra.geometry.GeoPosition;
import org.dfra.report.terminal.LiveBlock;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;

/** A team at one moment is a table whose columns stay where they are. */
class SnapshotLinesTest {

  private static final Instant BEGIN = Instant.parse("2026-11-22T00:00:00Z");
  private static final Instant NOW = BEGIN.plusMillis(142_400);

  private static final Robot UNSEEN =
      new Robot("ugv4", Availability.ABSENT, false, null, null, null, null, null);
  private static final Robot UAV =
      new Robot(
          "uav",
          Availability.PRESENT,
          true,
          agent(RequesterPhase.AWARDED, "ugv1", ResponderPhase.FREE, null, 0),
          null,
          null,
          null,
          0.98);

  private static RecruitmentStatus agent(
      RequesterPhase requester,
      @Nullable String helper,
      ResponderPhase responder,
      @Nullable String helped,
      double urge) {
    return new RecruitmentStatus(NOW, requester, helper, responder, helped, urge, "as it is");
  }

  private static RecruitmentStatus responder(ResponderPhase phase, double urge) {
    return agent(
        RequesterPhase.IDLE, null, phase, phase == ResponderPhase.FREE ? null : "uav", urge);
  }

  private static BehaviorStatus search(Phase phase, double done) {
    return new BehaviorStatus(NOW, null, phase, "lane 1 of 4", done, 0);
  }

  private static Robot ugv(
      @Nullable RecruitmentStatus agent,
      @Nullable BehaviorStatus search,
      @Nullable Double distance,
      @Nullable Double lease) {
    return new Robot("ugv1", Availability.PRESENT, false, agent, search, distance, lease, 0.5);
  }

  private static List<String> lines(@Nullable CallState call, Robot... robots) {
    return lines(79, call, robots);
  }

  private static List<String> lines(int columns, @Nullable CallState call, Robot... robots) {
    return SnapshotLines.of(new Snapshot(BEGIN, NOW, List.of(robots), call), columns);
  }

  private static CallState call(@Nullable String chosen, String... lost) {
    return new CallState(
        "uav",
        2,
        new GeoPosition(48, 11, 0),
        BEGIN.plusSeconds(130),
        chosen,
        Arrays.asList(lost),
        3,
        9,
        null);
  }

  /** The text under a heading in the line of the only robot. */
  private static String under(String heading, Robot robot) {
    List<String> headings =
        List.of("ROBOT", "ACTIVITY", "RECRUITMENT", "SHAME", "DISTANCE", "LEASE", "CHARGE", "");
    List<String> lines = lines(null, robot);
    List<Integer> ends = new ArrayList<>(List.of(0, 7, 25, 45, 55, 65, 72, 78));
    int column = headings.indexOf(heading);
    String cells = String.format("%-80s", lines.get(3));
    assertThat(
            String.format("%-80s", lines.get(2))
                .substring(ends.get(column), ends.get(column + 1))
                .strip())
        .isEqualTo(heading);
    return cells.substring(ends.get(column), ends.get(column + 1)).strip();
  }

  @Test
  void aTeamAtWorkIsATable() {
    assertThat(
            lines(
                call("ugv1"),
                UAV,
                ugv(
                    responder(ResponderPhase.TRAVELLING, 0),
                    search(Phase.PAUSED, 0.2),
                    12.34,
                    null),
                new Robot(
                    "ugv2",
                    Availability.PRESENT,
                    false,
                    responder(ResponderPhase.FREE, 0.45),
                    search(Phase.RUNNING, 0.239),
                    null,
                    null,
                    1.0)))
        .containsExactly(
            "",
            "Now, after 142 s of the robots' time; no message loss is simulated:",
            "ROBOT  ACTIVITY          RECRUITMENT         SHAME     DISTANCE  LEASE  CHARGE",
            "uav    flying            awaits ugv1         ..... 0.00                   98 %",
            "ugv1   on its way        responds to uav     ..... 0.00  12.3 m           50 %",
            "ugv2   searching, 23 %   idle                ##... 0.45                  100 %",
            "Call 2 by uav, 12 s ago: ugv1 chosen; HELP sent 3 times, 9 messages");
  }

  @Test
  void noLineIsWiderThanAUsualTerminal() {
    Robot widest =
        new Robot(
            "ugv1",
            Availability.UNREACHABLE,
            false,
            responder(ResponderPhase.FREE, 1),
            search(Phase.RUNNING, 1),
            999.94,
            600.0,
            1.0);
    assertThat(lines(call("ugv4", "ugv2"), widest, UAV, UNSEEN))
        .allSatisfy(line -> assertThat(line.length()).isBetween(0, 79));
  }

  @Test
  void whatIsNotKnownIsAQuestionMark() {
    assertThat(lines(null, UNSEEN).get(3))
        .isEqualTo(
            "ugv4   ?                 ?                   ?                               ?");
    Robot fresh = new Robot("ugv1", Availability.PRESENT, false, null, null, null, null, null);
    assertThat(lines(null, fresh).get(3))
        .as("it is there, and has reported nothing yet")
        .isEqualTo(
            "ugv1   waiting           idle                ..... 0.00                      ?");
    Robot nameless =
        ugv(
            agent(RequesterPhase.BEING_HELPED, null, ResponderPhase.FREE, null, 0),
            null,
            null,
            null);
    assertThat(under("RECRUITMENT", nameless)).isEqualTo("helped by ?");
  }

  @Test
  void aDeadRobotIsDeadAndNothingElse() {
    Robot dead =
        new Robot(
            "ugv2",
            Availability.DEAD,
            false,
            responder(ResponderPhase.TRAVELLING, 1),
            search(Phase.RUNNING, 0.5),
            3.0,
            60.0,
            0.9);
    assertThat(lines(null, dead).get(3)).isEqualTo("ugv2   dead");
  }

  @Test
  void aRobotDoesWhatItsAgentOrElseItsSearchReports() {
    BehaviorStatus paused = search(Phase.PAUSED, 0.5);
    assertThat(under("ACTIVITY", ugv(responder(ResponderPhase.ARRIVED, 0), paused, null, null)))
        .isEqualTo("there");
    assertThat(under("ACTIVITY", ugv(responder(ResponderPhase.LEASED, 0), paused, null, null)))
        .isEqualTo("observing");
    assertThat(under("ACTIVITY", ugv(responder(ResponderPhase.FREE, 0), paused, null, null)))
        .isEqualTo("paused, 50 %");
    assertThat(
            under(
                "ACTIVITY",
                ugv(
                    responder(ResponderPhase.OFFERED, 1),
                    search(Phase.RUNNING, 0.999),
                    null,
                    null)))
        .isEqualTo("searching, 99 %");
    assertThat(under("ACTIVITY", ugv(null, search(Phase.SUCCEEDED, 1), null, null)))
        .isEqualTo("search complete");
    assertThat(under("ACTIVITY", ugv(null, search(Phase.FAILED, 0), null, null)))
        .isEqualTo("search failed");
    assertThat(under("ACTIVITY", ugv(null, search(Phase.CANCELLED, 0.5), null, null)))
        .isEqualTo("stopped, 50 %");
    assertThat(under("ACTIVITY", ugv(null, search(Phase.IDLE, 0), null, null)))
        .isEqualTo("waiting");
    assertThat(under("ACTIVITY", ugv(null, null, null, null))).isEqualTo("waiting");
  }

  @Test
  void recruitmentNamesTheOther() {
    assertThat(under("RECRUITMENT", ugv(responder(ResponderPhase.OFFERED, 1), null, null, null)))
        .isEqualTo("offers to uav");
    assertThat(under("RECRUITMENT", ugv(responder(ResponderPhase.LEASED, 1), null, null, null)))
        .isEqualTo("responds to uav");
    assertThat(
            under(
                "RECRUITMENT",
                ugv(
                    agent(RequesterPhase.CALLING, null, ResponderPhase.FREE, null, 0),
                    null,
                    null,
                    null)))
        .isEqualTo("requests");
    assertThat(
            under(
                "RECRUITMENT",
                ugv(
                    agent(RequesterPhase.BEING_HELPED, "ugv3", ResponderPhase.FREE, null, 0),
                    null,
                    null,
                    null)))
        .isEqualTo("helped by ugv3");
    Robot cutOff =
        new Robot("uav", Availability.UNREACHABLE, true, UAV.agent(), null, null, null, 0.9);
    assertThat(under("RECRUITMENT", cutOff)).isEqualTo("unreachable");
    assertThat(under("ACTIVITY", cutOff)).isEqualTo("flying");
  }

  @Test
  void theBarIsFullOnlyWhereShameIs() {
    assertThat(under("SHAME", ugv(responder(ResponderPhase.FREE, 0.996), null, null, null)))
        .isEqualTo("####. 0.99");
    assertThat(under("SHAME", ugv(responder(ResponderPhase.OFFERED, 1), null, null, null)))
        .isEqualTo("##### 1.00");
  }

  @Test
  void aLeaseIsCountedInSeconds() {
    Robot observes = ugv(responder(ResponderPhase.LEASED, 0), null, null, 118.6);
    assertThat(under("LEASE", observes)).isEqualTo("119 s");
    assertThat(under("DISTANCE", observes)).isEmpty();
  }

  @Test
  void theCallShowsWhoIsChosenAndWhoIsLost() {
    assertThat(lines(null).get(3)).isEqualTo("No robot calls for help.");
    assertThat(lines(call(null)).get(3))
        .isEqualTo("Call 2 by uav, 12 s ago: no helper chosen; HELP sent 3 times, 9 messages");
    assertThat(lines(120, call("ugv4", "ugv2", "ugv1")).get(3))
        .isEqualTo(
            "Call 2 by uav, 12 s ago: ugv4 chosen, ugv2 and ugv1 lost; HELP sent 3 times, 9"
                + " messages");
  }

  @Test
  void longNamesWidenTheirColumnForAll() {
    Robot named =
        new Robot("pathfinder", Availability.PRESENT, false, null, null, null, null, null);
    List<String> lines = lines(120, null, named, UAV);
    int column = lines.get(2).indexOf("ACTIVITY");
    assertThat(column).isEqualTo("pathfinder".length() + 2);
    assertThat(lines.get(3).substring(column)).startsWith("waiting");
    assertThat(lines.get(4).substring(column)).startsWith("flying");
  }

  @Test
  void onANarrowTerminalTheNumbersStandBelowAndNothingIsCut() {
    Robot goes = ugv(responder(ResponderPhase.TRAVELLING, 0), search(Phase.PAUSED, 1), 12.34, null);
    List<String> lines = lines(59, call("ugv1", "ugv2"), goes);
    assertThat(lines)
        .containsExactly(
            "",
            "Now, after 142 s of the robots' time; no message loss is",
            "   simulated:",
            "ROBOT  ACTIVITY          RECRUITMENT",
            "     SHAME     DISTANCE  LEASE  CHARGE",
            "ugv1   on its way        responds to uav",
            "     ..... 0.00  12.3 m           50 %",
            "Call 2 by uav, 12 s ago: ugv1 chosen, ugv2 lost; HELP sent",
            "   3 times, 9 messages")
        .allMatch(line -> line.length() <= 59);
  }

  @Test
  void aCallOfManyWordsGoesOnBelow() {
    assertThat(lines(call("ugv4", "ugv2", "ugv1")))
        .endsWith(
            "Call 2 by uav, 12 s ago: ugv4 chosen, ugv2 and ugv1 lost; HELP sent 3 times, 9",
            "   messages");
  }

  @Test
  void onANarrowTerminalWhatMattersMostIsLeft() {
    String line =
        lines(null, ugv(responder(ResponderPhase.TRAVELLING, 0), null, 12.34, null)).get(3);
    assertThat(LiveBlock.cut(line, 40)).isEqualTo("ugv1   on its way        responds to ua…");
    assertThat(LiveBlock.cut(line, 12)).isEqualTo("ugv1   on i…");
  }
}
