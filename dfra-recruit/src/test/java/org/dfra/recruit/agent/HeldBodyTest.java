package org.dfra.recruit.agent;

import static org.assertj.core.api.Assertions.assertThat;
import static org.dfra.recruit.agent.BodyModules.at;

import java.rmi.RemoteException;
import java.util.List;
import java.util.UUID;
import org.dfra.behavior.BehaviorStatus.Phase;
import org.dfra.behavior.LegGoal;
import org.dfra.core.behavior.GoalProgress;
import org.dfra.flow.effector.DriveEffector;
import org.dfra.persona.EmergencyStopAttributes;
import org.dfra.recruit.agent.BodyModules.Driver;
import org.junit.jupiter.api.Test;

/** A robot that was stopped by a person answers no call until a person resumes it. */
class HeldBodyTest extends BodyFixture {

  private boolean isFree() {
    modules.step(0.6);
    position.see(0, 0);
    modules.step(0.1);
    return body.isAvailable();
  }

  /** The agent's process is killed, and there is another. */
  private void restartAgent() {
    body.close();
    body = body();
  }

  /** Helps, and is stopped on its way; its agent is free again then. */
  private void stopOnItsWay(boolean isPaused) throws RemoteException {
    body.travelTo(CALL, Long.MAX_VALUE, journey);
    modules.step(1);
    if (isPaused) {
      driver.pause();
    } else {
      driver.cancel();
    }
    modules.step(0.6);
    assertThat(reports).hasSize(1);
    body.resumeOwnWork();
  }

  @Test
  void oneWhoseTripSomebodyStoppedIsNotFreeUntilItsSearchIsResumed() throws RemoteException {
    UUID unused = search.pursue(FIELD);
    for (boolean isPaused : List.of(true, false)) {
      reports.clear();
      modules.step(1);
      assertThat(isFree()).isTrue();
      stopOnItsWay(isPaused);
      assertThat(body.isAvailable()).as("not for a moment").isFalse();
      assertThat(isFree()).isFalse();
      assertThat(body.holdReason().orElseThrow()).contains("ugv1/go_to_waypoint");
      restartAgent();
      assertThat(isFree()).as("its next process knows it too").isFalse();
      search.resume();
      assertThat(isFree()).as("a person let it go on").isTrue();
    }
  }

  @Test
  void oneWhoseTripSomebodyStoppedIsFreeAfterAnotherGoal() throws RemoteException {
    stopOnItsWay(false);
    assertThat(isFree()).isFalse();
    UUID unused = driver.pursue(new LegGoal(null, at(1, 1), 1));
    modules.step(1);
    driver.progress = GoalProgress.reached("it is there");
    assertThat(isFree()).isTrue();
    assertThat(driver.status().phase()).isEqualTo(Phase.SUCCEEDED);
  }

  @Test
  void oneWhoseTripSomebodyStoppedIsFreeWhereAPersonSaysSo() throws RemoteException {
    stopOnItsWay(true);
    assertThat(isFree()).isFalse();
    body.endHold();
    assertThat(isFree()).isTrue();
    restartAgent();
    assertThat(isFree()).isTrue();
  }

  @Test
  void oneWhoseSearchSomebodyStoppedIsNotFree() throws RemoteException {
    UUID unused = search.pursue(FIELD);
    modules.step(1);
    search.pause();
    assertThat(isFree()).isFalse();
    restartAgent();
    assertThat(isFree()).isFalse();
    search.resume();
    assertThat(isFree()).isTrue();
    search.cancel();
    assertThat(isFree()).isFalse();
    restartAgent();
    assertThat(isFree()).isFalse();
    body.endHold();
    assertThat(isFree()).isTrue();
  }

  /** In a new process nothing is found at first. */
  @Test
  void oneWhoseTripSomebodyStoppedIsNotFreeBeforeItsModulesAreFoundAgain() throws RemoteException {
    stopOnItsWay(true);
    assertThat(isFree()).isFalse();
    body.close();
    modules.hide(driver);
    body = body();
    assertThat(isFree()).isFalse();
    modules.show(driver);
    assertThat(isFree()).isFalse();
    body.endHold();
    modules.hide(driver);
    assertThat(isFree()).isTrue();
    modules.show(driver);
  }

  @Test
  void whatHappensWhileItsAgentIsDeadCountsToo() throws RemoteException {
    UUID unused = search.pursue(FIELD);
    modules.step(1);
    body.close();
    search.pause();
    modules.step(1);
    body = body();
    assertThat(isFree()).isFalse();
  }

  @Test
  void oneThatWasStoppedForAnEmergencyIsHeldAlsoAfterTheRelease() {
    UUID drive = UUID.randomUUID();
    list(drive, false);
    assertThat(isFree()).isTrue();
    list(drive, true);
    assertThat(isFree()).isFalse();
    body.endHold();
    assertThat(isFree()).as("only a release ends an emergency stop").isFalse();
    modules.step(1);
    list(drive, false); // released
    assertThat(isFree()).isFalse();
    restartAgent();
    assertThat(isFree()).isFalse();
    body.endHold();
    assertThat(isFree()).isTrue();
    body.close();
    modules.step(1);
    list(drive, false); // stopped and released while the agent was dead
    body = body();
    assertThat(isFree()).isFalse();
  }

  @Test
  void anEmergencyStopThatItsFirstProcessFindsHoldsItAfterTheRelease() {
    UUID drive = UUID.randomUUID();
    list(drive, true);
    assertThat(isFree()).isFalse();
    modules.step(1);
    list(drive, false);
    assertThat(isFree()).isFalse();
  }

  private void list(UUID id, boolean isStopped) {
    DriveEffector drive = BodyModules.stub(DriveEffector.class, () -> {});
    modules.list(
        id,
        "drive",
        drive,
        new EmergencyStopAttributes(isStopped, "somebody", modules.time.instant()));
  }

  @Test
  void itStandsWhereSomebodyPausesOrCancelsItsSearchWhileItIsOnItsWay() throws RemoteException {
    for (boolean isPaused : List.of(true, false)) {
      reports.clear();
      UUID unused = search.pursue(FIELD);
      modules.step(1);
      body.travelTo(CALL, Long.MAX_VALUE, journey);
      modules.step(1);
      assertThat(driver.status().phase()).isEqualTo(Phase.RUNNING);
      if (isPaused) {
        search.pause();
      } else {
        search.cancel();
      }
      modules.step(0.6);
      assertThat(driver.status().phase()).isEqualTo(Phase.CANCELLED);
      assertThat(reports).hasSize(1);
      body.resumeOwnWork();
      assertThat(isFree()).isFalse();
      search.cancel();
    }
  }

  /** It cannot be asked at first, and is found again when the agent sets out. */
  @Test
  void itDoesNotSetOutWhereWhatDrivesItWasStoppedBefore() throws RemoteException {
    stopOnItsWay(false);
    reports.clear();
    modules.end(driver);
    modules.step(1);
    body.travelTo(CALL, Long.MAX_VALUE, journey);
    modules.step(1);
    Driver again = modules.add(new Driver(modules.context("go_to_waypoint")));
    modules.step(2);
    assertThat(again.goal).isNull();
    assertThat(reports).hasSize(1);
  }
}
