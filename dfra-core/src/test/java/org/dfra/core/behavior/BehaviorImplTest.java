package org.dfra.core.behavior;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.awaitility.Awaitility.await;

import java.util.UUID;
import org.dfra.behavior.BehaviorStatus;
import org.dfra.behavior.BehaviorStatus.Phase;
import org.dfra.behavior.GoalRefusedException;
import org.dfra.module.NotReadyException;
import org.dfra.persona.BehaviorAttributes;
import org.junit.jupiter.api.Test;

/** What a behaviour does for the clients that give it goals. */
class BehaviorImplTest extends GenieFixture {

  @Test
  void reachesAGoalAndReportsItsProgress() throws Exception {
    assertThat(genie.status().phase()).isEqualTo(Phase.IDLE);
    UUID goal = genie.pursue(new Wish("gold"));
    turns.add(GoalProgress.inProgress("it digs", 0.4));
    awaitPublished("it digs");
    turns.add(GoalProgress.inProgress("it digs on", 0.3)); // never falls
    awaitPublished("it digs on");
    assertThat(genie.status().completion()).isEqualTo(0.4);
    turns.add(GoalProgress.reached("here it is"));
    awaitPhase(genie, Phase.SUCCEEDED);
    awaitPublished("here it is");
    assertThat(genie.status().goal()).isEqualTo(goal);
    assertThat(genie.status().completion()).isEqualTo(1);
    assertThat(rests.get()).as("it is suspended once").isEqualTo(1);
    assertThat(published).allMatch(status -> goal.equals(status.goal()));
  }

  @Test
  void countsThePartsOfItsGoal() throws Exception {
    UUID unused = genie.pursue(new Wish("three wishes"));
    turns.add(GoalProgress.inProgress("it grants", 0.4).withSkippedParts(1).withParts(1, 3));
    awaitPublished("it grants");
    turns.add(
        GoalProgress.inProgress("it grants", 0.4)
            .withSkippedParts(1)
            .withParts(2, 3)); // the same activity, and yet a new status
    await().atMost(PATIENCE).until(() -> published.get(published.size() - 1).completedParts() == 2);
    genie.pause();
    BehaviorStatus paused = genie.status();
    assertThat(paused.completedParts()).isEqualTo(2);
    assertThat(paused.totalParts()).isEqualTo(3);
    assertThat(paused.skippedParts()).isEqualTo(1);
  }

  @Test
  void pausesKeepsTheGoalAndGoesOn() throws Exception {
    UUID goal = genie.pursue(new Wish("gold"));
    turns.add(GoalProgress.inProgress("it digs", 0.4));
    awaitPublished("it digs");

    genie.pause();
    int paused = steps.get();
    assertThat(genie.status().phase()).isEqualTo(Phase.PAUSED);
    assertThat(rests.get()).isEqualTo(1);
    genie.pause();
    assertThat(rests.get()).as("the second time nothing is done").isEqualTo(1);
    assertThatThrownBy(() -> genie.pursue(new Wish("silver")))
        .isInstanceOf(GoalRefusedException.class)
        .hasMessage(
            "atrv1/genie pursues another goal (a client paused it); cancel that first, or wait for"
                + " its end");
    assertThat(steps.get()).as("no turns while it is paused").isEqualTo(paused);

    genie.resume();
    await().atMost(PATIENCE).until(() -> steps.get() > paused);
    assertThat(genie.status().goal()).isEqualTo(goal);
    genie.cancel();
    assertThat(genie.status().phase()).isEqualTo(Phase.CANCELLED);
    assertThat(rests.get()).isEqualTo(2);
    assertThat(genie.pursue(new Wish("silver"))).isNotEqualTo(goal);
  }

  @Test
  void aProgramResumesWhatAProgramPausedAndNothingElse() throws Exception {
    UUID goal = genie.pursue(new Wish("gold"));
    genie.pauseUnattended();
    assertThat(genie.status().phase()).isEqualTo(Phase.PAUSED);
    genie.resumeUnattended();
    assertThat(genie.status().phase()).isEqualTo(Phase.RUNNING);

    genie.pauseUnattended();
    genie.pause(); // somebody steps in front of it
    genie.pauseUnattended(); // which changes nothing
    genie.resumeUnattended();
    assertThat(genie.status().phase()).as("a person paused it since").isEqualTo(Phase.PAUSED);
    genie.resume();
    assertThat(genie.status().phase()).isEqualTo(Phase.RUNNING);

    genie.pause();
    genie.resumeUnattended();
    assertThat(genie.status().phase()).as("a person paused it").isEqualTo(Phase.PAUSED);
    genie.resume();

    genie.pauseUnattended();
    genie.resume();
    turns.add(GoalProgress.paused("its brake is set", 0.5));
    awaitPhase(genie, Phase.PAUSED);
    genie.resumeUnattended();
    assertThat(genie.status().phase()).as("a brake paused it").isEqualTo(Phase.PAUSED);
    assertThat(genie.status().goal()).isEqualTo(goal);
  }

  @Test
  void givesUpTheGoalThatIsNamedAndNoOther() throws Exception {
    UUID goal = genie.pursue(new Wish("gold"));
    genie.cancel(UUID.randomUUID());
    assertThat(genie.status().phase()).isEqualTo(Phase.RUNNING);
    genie.cancel(goal);
    assertThat(genie.status().phase()).isEqualTo(Phase.CANCELLED);
    UUID next = genie.pursueUnattended(new Wish("silver"));
    genie.cancel(goal);
    assertThat(genie.status().phase()).as("the newer goal goes on").isEqualTo(Phase.RUNNING);
    assertThat(genie.status().goal()).isEqualTo(next);
  }

  @Test
  void refusesAGoalBeforeAnythingIsDone() {
    assertThatThrownBy(() -> genie.pursue(new Wish("")))
        .hasMessage("a wish for nothing; wish for something");
    assertThat(genie.status().phase()).isEqualTo(Phase.IDLE);
    assertThat(steps.get()).isZero();
  }

  @Test
  void comesToRestWhenItIsClosed() throws Exception {
    UUID unused = genie.pursue(new Wish("gold"));
    await().atMost(PATIENCE).until(() -> steps.get() > 0);
    genie.close();
    assertThat(rests.get()).isEqualTo(1);
    assertThatThrownBy(() -> genie.pursue(new Wish("gold"))).isInstanceOf(NotReadyException.class);
  }

  @Test
  void publishesItsPhaseInItsPersona() throws Exception {
    assertThat(genie.attributes()).contains(new BehaviorAttributes("Wish", false, "IDLE", 50));
    UUID unused = genie.pursue(new Wish("gold"));
    assertThat(genie.attributes()).contains(new BehaviorAttributes("Wish", false, "RUNNING", 50));
  }
}
