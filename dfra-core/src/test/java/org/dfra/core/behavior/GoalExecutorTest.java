package org.dfra.core.behavior;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.awaitility.Awaitility.await;

import java.rmi.RemoteException;
import java.util.List;
import java.util.UUID;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.CyclicBarrier;
import java.util.concurrent.TimeUnit;
import org.dfra.behavior.BehaviorStatus.Phase;
import org.dfra.behavior.GoalRefusedException;
import org.dfra.flow.effector.BrakeEngagedException;
import org.dfra.flow.effector.CommandRefusedByEmergencyStopException;
import org.dfra.lifecycle.Readiness;
import org.dfra.module.NotReadyException;
import org.junit.jupiter.api.Test;

/** The results of the steps of a goal, also where one is held up or fails. */
class GoalExecutorTest extends GenieFixture {

  @Test
  void numbersThatCannotBeAreAFaultThatEndsTheGoal() throws Exception {
    UUID unused = genie.pursue(new Wish("three wishes"));
    turns.add(GoalProgress.inProgress("it grants", 0.4).withParts(4, 3));
    awaitPhase(genie, Phase.FAILED);
    assertThat(genie.status().activity()).contains("parts done 4 is outside 0 to 3");
  }

  @Test
  void waitsAtRestForWhatIsMissingAndGoesOn() throws Exception {
    UUID goal = genie.pursue(new Wish("gold"));
    turns.add(GoalProgress.inProgress("it digs", 0.4));
    awaitPublished("it digs");
    turns.add(new NotReadyException("atrv1/laser", Readiness.INITIALIZING, "no scan has come yet"));
    awaitPublished("it waits: atrv1/laser is INITIALIZING: no scan has come yet");
    assertThat(rests.get()).isGreaterThan(0);
    turns.add(new RemoteException("it is out of reach"));
    awaitPublished("it waits: it is out of reach");
    turns.add(new RemoteException("the link broke", new java.io.IOException("reset")));
    awaitPublished("it waits: a call failed: the link broke");
    assertThat(genie.status().phase()).isEqualTo(Phase.RUNNING);
    turns.add(GoalProgress.reached("here it is"));
    awaitPhase(genie, Phase.SUCCEEDED);
    assertThat(genie.status().goal()).isEqualTo(goal);
  }

  @Test
  void givesUpWhereAnEffectorIsStoppedForAnEmergencyAndDoesNotGoOnWhenItIsReleased()
      throws Exception {
    UUID unused = genie.pursue(new Wish("gold"));
    turns.add(
        new CommandRefusedByEmergencyStopException("atrv1/drive is stopped for an emergency"));
    awaitPhase(genie, Phase.CANCELLED);
    assertThat(genie.status().activity()).isEqualTo("atrv1/drive is stopped for an emergency");
    assertThat(rests.get()).isPositive();
    turns.add(GoalProgress.inProgress("it digs", 0.4)); // it is released: a cycle would take this
    int stepped = steps.get();
    UUID again = genie.pursue(new Wish("silver"));
    awaitPublished("it digs");
    assertThat(steps.get()).as("only for the new goal").isGreaterThan(stepped);
    assertThat(published)
        .filteredOn(each -> each.activity().equals("it digs"))
        .allMatch(each -> again.equals(each.goal()));
  }

  @Test
  void pausesWhereABrakeIsSetAndGoesOnWhenSomebodyResumesIt() throws Exception {
    UUID goal = genie.pursue(new Wish("gold"));
    turns.add(new BrakeEngagedException("atrv1/drive has its brake set"));
    awaitPhase(genie, Phase.PAUSED);
    assertThat(genie.status().activity())
        .isEqualTo("atrv1/drive has its brake set; when it may move, resume the goal");
    assertThat(rests.get()).isPositive();
    int stepped = steps.get();
    turns.add(GoalProgress.reached("here it is")); // it is released: a cycle would take this
    genie.resume();
    awaitPhase(genie, Phase.SUCCEEDED);
    assertThat(steps.get()).as("none before it was resumed").isEqualTo(stepped + 1);
    assertThat(genie.status().goal()).isEqualTo(goal);
  }

  @Test
  void givesUpAtAFaultOfItsOwnAndCanBeAskedAgain() throws Exception {
    UUID unused = genie.pursue(new Wish("gold"));
    turns.add(new IllegalStateException("the lamp is broken"));
    awaitPhase(genie, Phase.FAILED);
    assertThat(genie.status().activity()).contains("the lamp is broken");
    assertThat(rests.get()).isEqualTo(1);
    assertThat(genie.history().recent())
        .anyMatch(incident -> incident.toString().contains("the lamp is broken"));
    turns.add(GoalProgress.reached("here it is"));
    UUID again = genie.pursue(new Wish("gold"));
    awaitPhase(genie, Phase.SUCCEEDED);
    assertThat(genie.status().goal()).isEqualTo(again);
  }

  @Test
  void pausingAndCancellingTakeEffectThoughACycleIsHeldUp() throws Exception {
    UUID goal = genie.pursue(new Wish("gold"));
    CountDownLatch mayEnd = new CountDownLatch(1);
    CountDownLatch held = hold(mayEnd);
    assertThat(held.await(20, TimeUnit.SECONDS)).isTrue();
    genie.pause();
    assertThat(genie.status().phase()).isEqualTo(Phase.PAUSED);
    assertThatThrownBy(() -> genie.pursue(new Wish("silver")))
        .isInstanceOf(GoalRefusedException.class)
        .hasMessage(
            "atrv1/genie waits for a module that does not answer; ask again in a few seconds");
    genie.cancel();
    assertThat(genie.status().phase()).isEqualTo(Phase.CANCELLED);
    assertThat(rests.get()).as("the cycle still runs").isZero();
    mayEnd.countDown();
    await().atMost(PATIENCE).until(() -> rests.get() == 1);
    assertThat(genie.status().phase())
        .as("the result of the cycle comes too late")
        .isEqualTo(Phase.CANCELLED);
    assertThat(genie.status().goal()).isEqualTo(goal);
    assertThat(genie.pursue(new Wish("silver"))).isNotEqualTo(goal);
  }

  @Test
  void closesThoughACycleIsHeldUpAndReportsThatToCallers() throws Exception {
    UUID unused = genie.pursue(new Wish("gold"));
    CountDownLatch held = hold(new CountDownLatch(1)); // it is interrupted
    assertThat(held.await(20, TimeUnit.SECONDS)).isTrue();
    genie.close();
    assertThat(rests.get()).isEqualTo(1);
    assertThatThrownBy(genie::status)
        .isInstanceOf(NotReadyException.class)
        .hasMessageContaining("it has ended before its goal was reached");
    await()
        .atMost(PATIENCE)
        .until(
            () ->
                Thread.getAllStackTraces().keySet().stream()
                    .noneMatch(thread -> thread.getName().endsWith(" atrv1/genie")));
  }

  /** The next cycle waits; the latch that is returned is counted down when it does. */
  private CountDownLatch hold(CountDownLatch mayEnd) {
    CountDownLatch held = new CountDownLatch(1);
    turns.add(
        (Runnable)
            () -> {
              held.countDown();
              try {
                mayEnd.await();
              } catch (InterruptedException e) {
                throw new NotReadyException("atrv1/laser", Readiness.READY, "it was interrupted");
              }
            });
    return held;
  }

  @Test
  void twoThatCallEachOtherDoNotWaitForEver() throws Exception {
    Genie other = new Genie("djinn");
    other.start();
    CyclicBarrier bothAtTurn = new CyclicBarrier(2);
    List<String> refusals = new CopyOnWriteArrayList<>();
    for (Genie each : List.of(genie, other)) {
      Genie partner = each == genie ? other : genie;
      each.script.add(
          (Runnable)
              () -> {
                try {
                  bothAtTurn.await(20, TimeUnit.SECONDS);
                  UUID unused = partner.pursue(new Wish("a wish of its own"));
                } catch (GoalRefusedException e) {
                  refusals.add(String.valueOf(e.getMessage()));
                } catch (Exception e) {
                  throw new IllegalStateException(e);
                }
              });
      UUID unused = each.pursue(new Wish("gold"));
    }
    await().atMost(PATIENCE).until(() -> refusals.size() == 2);
    other.close();
  }

  @Test
  void waitsWhereAnotherIsBusyAndFailsWhereItRefuses() throws Exception {
    UUID unused = genie.pursue(new Wish("gold"));
    turns.add(GoalRefusedException.busy("atrv1/lamp pursues another goal"));
    awaitPublished("it waits: atrv1/lamp pursues another goal");
    turns.add(new GoalRefusedException("there is no gold"));
    awaitPhase(genie, Phase.FAILED);
    assertThat(genie.status().activity()).contains("there is no gold");
  }

  @Test
  void failsAtAnErrorTooSinceNobodyDrivesOn() throws Exception {
    UUID unused = genie.pursue(new Wish("gold"));
    turns.add(new NoClassDefFoundError("lamp"));
    awaitPhase(genie, Phase.FAILED);
    assertThat(rests.get()).isEqualTo(1);
  }

  @Test
  void isHeldOrCancelledWhereWhatWorksForItWasGivenUp() throws Exception {
    UUID goal = genie.pursue(new Wish("gold"));
    turns.add(GoalProgress.paused("its lamp was taken", 0.5));
    awaitPhase(genie, Phase.PAUSED);
    assertThat(genie.status().activity()).isEqualTo("its lamp was taken");
    assertThat(rests.get()).isEqualTo(1);
    turns.add(GoalProgress.cancelled("its lamp was broken", 0.6));
    genie.resume();
    awaitPhase(genie, Phase.CANCELLED);
    assertThat(genie.status().goal()).isEqualTo(goal);
    assertThat(genie.status().completion()).isEqualTo(0.6);
  }
}
