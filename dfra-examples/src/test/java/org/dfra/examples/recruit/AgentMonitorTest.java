package org.dfra.examples.recruit;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Instant;
import java.util.List;
import java.util.Map;
import org.dfra.agent.RecruitmentStatus;
import org.dfra.agent.RequesterPhase;
import org.dfra.agent.ResponderPhase;
import org.junit.jupiter.api.Test;

/** The time in which two helped at once is counted also if the end of helping was not reported. */
class AgentMonitorTest {

  private static final Instant BEGIN = Instant.parse("2026-11-22T00:00:00Z");

  private static RecruitmentStatus at(int second, ResponderPhase phase) {
    return new RecruitmentStatus(
        BEGIN.plusSeconds(second), RequesterPhase.IDLE, null, phase, null, 0, "as it is");
  }

  private static final List<RecruitmentStatus> TEN_TO_THIRTY =
      List.of(at(10, ResponderPhase.TRAVELLING), at(30, ResponderPhase.FREE));

  @Test
  void spansThatWereEndedOverlap() {
    List<RecruitmentStatus> other =
        List.of(at(25, ResponderPhase.TRAVELLING), at(40, ResponderPhase.FREE));
    assertThat(AgentMonitor.overlapSeconds(Map.of("ugv1", TEN_TO_THIRTY, "ugv2", other), Map.of()))
        .isEqualTo(5);
  }

  @Test
  void aHelperThatNeverReportedItsEndHelpsUntilTheLastReport() {
    List<RecruitmentStatus> open = List.of(at(12, ResponderPhase.TRAVELLING));
    assertThat(AgentMonitor.overlapSeconds(Map.of("ugv1", TEN_TO_THIRTY, "ugv2", open), Map.of()))
        .as("one of them")
        .isEqualTo(18);
    assertThat(
            AgentMonitor.overlapSeconds(
                Map.of("ugv1", List.of(at(10, ResponderPhase.LEASED)), "ugv2", open), Map.of()))
        .as("both of them, until the latter's beginning, which was reported last")
        .isZero();
    List<RecruitmentStatus> silent = List.of(at(50, ResponderPhase.FREE));
    assertThat(
            AgentMonitor.overlapSeconds(
                Map.of("ugv1", List.of(at(10, ResponderPhase.LEASED)), "ugv2", open, "x", silent),
                Map.of()))
        .as("both of them, until another reported something")
        .isEqualTo(38);
  }

  @Test
  void aHelperThatDiedHelpsNoLongerThoughItsRestartedAgentReportsLaterThatItIsFree() {
    List<RecruitmentStatus> restarted =
        List.of(at(5, ResponderPhase.TRAVELLING), at(14, ResponderPhase.FREE));
    Map<String, List<RecruitmentStatus>> both = Map.of("ugv1", TEN_TO_THIRTY, "ugv2", restarted);
    assertThat(AgentMonitor.overlapSeconds(both, Map.of("ugv2", BEGIN.plusSeconds(8)))).isZero();
    assertThat(AgentMonitor.overlapSeconds(both, Map.of("ugv2", BEGIN.plusSeconds(11))))
        .as("it died a second after the other had come")
        .isEqualTo(1);
    assertThat(AgentMonitor.overlapSeconds(both, Map.of("ugv2", BEGIN.plusSeconds(20))))
        .as("it died when it did not help any more")
        .isEqualTo(4);
  }

  @Test
  void aHelperThatDiedHelpsNoLonger() {
    List<RecruitmentStatus> open = List.of(at(5, ResponderPhase.TRAVELLING));
    assertThat(
            AgentMonitor.overlapSeconds(
                Map.of("ugv1", TEN_TO_THIRTY, "ugv2", open), Map.of("ugv2", BEGIN.plusSeconds(8))))
        .as("it died before another came")
        .isZero();
    List<RecruitmentStatus> back = List.of(at(12, ResponderPhase.TRAVELLING));
    assertThat(
            AgentMonitor.overlapSeconds(
                Map.of("ugv1", TEN_TO_THIRTY, "ugv2", back), Map.of("ugv2", BEGIN.plusSeconds(8))))
        .as("it came back, and helps again")
        .isEqualTo(18);
  }
}
