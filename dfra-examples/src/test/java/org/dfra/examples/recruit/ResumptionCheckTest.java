package org.dfra.examples.recruit;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.UUID;
import org.dfra.agent.RecruitmentStatus;
import org.dfra.agent.RequesterPhase;
import org.dfra.agent.ResponderPhase;
import org.dfra.behavior.BehaviorStatus;
import org.dfra.behavior.BehaviorStatus.Phase;
import org.dfra.examples.recruit.ResumptionCheck.ResumptionFault;
import org.junit.jupiter.api.Test;

/** Whether a robot resumed is judged by its reports, in the order of its own clock. */
class ResumptionCheckTest {

  private static final Instant BEGIN = Instant.parse("2026-11-22T00:00:00Z");
  private static final UUID SEARCH = new UUID(0, 1);
  private static final UUID ANOTHER = new UUID(0, 2);

  /** Offers after 10 s, sets out after 11 s, is there after 30 s, and is free after 50 s. */
  private static final List<RecruitmentStatus> HELPED =
      List.of(
          agent(10, ResponderPhase.OFFERED),
          agent(11, ResponderPhase.TRAVELLING),
          agent(30, ResponderPhase.ARRIVED),
          agent(31, ResponderPhase.LEASED),
          agent(50, ResponderPhase.FREE));

  private static final BehaviorStatus RUNS = search(1, SEARCH, Phase.RUNNING, 0.25);
  private static final BehaviorStatus PAUSES = search(12, SEARCH, Phase.PAUSED, 0.25);

  private static RecruitmentStatus agent(int second, ResponderPhase phase) {
    return new RecruitmentStatus(
        BEGIN.plusSeconds(second), RequesterPhase.IDLE, null, phase, "uav", 0, "as it is");
  }

  private static BehaviorStatus search(int second, UUID goal, Phase phase, double done) {
    return new BehaviorStatus(BEGIN.plusSeconds(second), goal, phase, "as reported", done, 0);
  }

  private static String why(BehaviorStatus... search) {
    return ResumptionCheck.fault(HELPED, List.of(search)).map(ResumptionFault::why).orElse("");
  }

  private static boolean hadSearched(BehaviorStatus... search) {
    return ResumptionCheck.fault(HELPED, List.of(search)).orElseThrow().hadSearched();
  }

  @Test
  void aRobotThatDoesMoreOfTheSearchThatItLeftHasResumed() {
    BehaviorStatus again = search(51, SEARCH, Phase.RUNNING, 0.25);
    assertThat(why(RUNS, PAUSES, again, search(70, SEARCH, Phase.RUNNING, 0.3))).isEmpty();
    assertThat(why(RUNS, PAUSES, again, search(70, SEARCH, Phase.SUCCEEDED, 1))).isEmpty();
  }

  @Test
  void aRobotThatNeverHelpedHasNothingToResume() {
    List<RecruitmentStatus> offered =
        List.of(agent(10, ResponderPhase.OFFERED), agent(15, ResponderPhase.FREE));
    assertThat(ResumptionCheck.fault(offered, List.of())).isEmpty();
    assertThat(ResumptionCheck.fault(List.of(), List.of())).isEmpty();
  }

  @Test
  void aRobotWithoutASearchWasNotSearching() {
    assertThat(why()).isEqualTo("was not searching when it was recruited: it had no search");
    assertThat(hadSearched()).isFalse();
    BehaviorStatus late = search(11, SEARCH, Phase.RUNNING, 0); // after it had offered
    assertThat(hadSearched(late)).isFalse();
  }

  @Test
  void aRobotWhoseSearchDidNotRunWasNotSearching() {
    for (Phase phase : List.of(Phase.IDLE, Phase.PAUSED, Phase.SUCCEEDED, Phase.FAILED)) {
      BehaviorStatus stood = search(9, SEARCH, phase, 0.5);
      BehaviorStatus later = search(51, SEARCH, Phase.RUNNING, 0.75);
      assertThat(why(RUNS, stood, PAUSES, later))
          .isEqualTo(
              "was not searching when it was recruited: its search was " + phase + ", as reported");
      assertThat(hadSearched(RUNS, stood, PAUSES, later)).isFalse();
    }
  }

  @Test
  void whatPausesForEverWasNotResumed() {
    assertThat(why(RUNS, PAUSES))
        .isEqualTo(
            "has not continued the search that it interrupted, which is PAUSED, as reported");
    assertThat(hadSearched(RUNS, PAUSES)).isTrue();
    assertThat(why(RUNS, PAUSES, search(60, SEARCH, Phase.FAILED, 0.25)))
        .endsWith("which is FAILED, as reported");
    assertThat(why(RUNS, PAUSES, search(60, SEARCH, Phase.CANCELLED, 0.5)))
        .as("done meanwhile, but given up")
        .endsWith("which is CANCELLED, as reported");
  }

  @Test
  void whatRunsWithoutProgressWasNotResumed() {
    assertThat(why(RUNS, PAUSES, search(51, SEARCH, Phase.RUNNING, 0.25)))
        .isEqualTo("searches again, but not beyond the 25 % at which it interrupted its search");
    BehaviorStatus ranOn = search(13, SEARCH, Phase.PAUSED, 0.5); // reported as it left
    assertThat(why(RUNS, ranOn, search(51, SEARCH, Phase.RUNNING, 0.5)))
        .isEqualTo("searches again, but not beyond the 50 % at which it interrupted its search");
  }

  @Test
  void anotherSearchIsNotTheOneThatWasLeft() {
    assertThat(why(RUNS, PAUSES, search(60, ANOTHER, Phase.RUNNING, 0.75)))
        .isEqualTo("started another search instead of the one that it had interrupted");
  }

  @Test
  void aRobotThatSearchedWhileItHelpedNeverLeft() {
    assertThat(why(RUNS, search(60, SEARCH, Phase.RUNNING, 0.75)))
        .isEqualTo("never interrupted its search to help");
  }

  @Test
  void aRobotThatIsStillAwayHasNotResumed() {
    assertThat(ResumptionCheck.fault(HELPED.subList(0, 4), List.of(RUNS, PAUSES)))
        .contains(new ResumptionFault(true, "was recruited and is not free again"));
  }

  @Test
  void eachTimeCounts() {
    List<RecruitmentStatus> twice = new ArrayList<>(HELPED);
    twice.add(agent(80, ResponderPhase.TRAVELLING));
    twice.add(agent(90, ResponderPhase.FREE));
    BehaviorStatus again = search(70, SEARCH, Phase.RUNNING, 0.3);
    BehaviorStatus left = search(81, SEARCH, Phase.PAUSED, 0.3);
    assertThat(
            ResumptionCheck.fault(
                twice, List.of(RUNS, PAUSES, again, left, search(95, SEARCH, Phase.RUNNING, 0.4))))
        .isEmpty();
    assertThat(ResumptionCheck.fault(twice, List.of(RUNS, PAUSES, again, left)))
        .as("the second time")
        .isPresent();
    BehaviorStatus over = search(75, SEARCH, Phase.SUCCEEDED, 1);
    assertThat(ResumptionCheck.fault(twice, List.of(RUNS, PAUSES, again, over)))
        .as("nothing was left to be called away from")
        .hasValueSatisfying(fault -> assertThat(fault.hadSearched()).isFalse());
  }

  @Test
  void aRobotThatIsCalledAgainBeforeItIsBackIsAwayOnce() {
    List<RecruitmentStatus> again = new ArrayList<>(HELPED);
    again.add(agent(51, ResponderPhase.OFFERED));
    again.add(agent(52, ResponderPhase.TRAVELLING));
    again.add(agent(60, ResponderPhase.FREE));
    BehaviorStatus late = search(61, SEARCH, Phase.RUNNING, 0.25);
    assertThat(
            ResumptionCheck.fault(
                again, List.of(RUNS, PAUSES, late, search(70, SEARCH, Phase.RUNNING, 0.5))))
        .isEmpty();
    assertThat(ResumptionCheck.fault(again, List.of(RUNS, PAUSES, late)))
        .as("no more was done after the second time")
        .hasValueSatisfying(fault -> assertThat(fault.hadSearched()).isTrue());
    BehaviorStatus idle = search(2, SEARCH, Phase.PAUSED, 0.25);
    assertThat(ResumptionCheck.fault(again, List.of(RUNS, idle, late)))
        .as("it did not search before the first time either")
        .hasValueSatisfying(fault -> assertThat(fault.hadSearched()).isFalse());
    BehaviorStatus back = search(50, SEARCH, Phase.RUNNING, 0.3);
    BehaviorStatus halted = search(51, SEARCH, Phase.PAUSED, 0.3);
    assertThat(ResumptionCheck.fault(again, List.of(RUNS, PAUSES, back, halted, late)))
        .as("it was back, and somebody halted it")
        .hasValueSatisfying(fault -> assertThat(fault.hadSearched()).isFalse());
  }
}
