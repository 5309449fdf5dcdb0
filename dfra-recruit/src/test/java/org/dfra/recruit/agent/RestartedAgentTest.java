package org.dfra.recruit.agent;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.rmi.RemoteException;
import java.util.ArrayList;
import java.util.List;
import java.util.UUID;
import org.dfra.behavior.BehaviorStatus.Phase;
import org.dfra.behavior.HomeGoal;
import org.dfra.behavior.ReturnHome;
import org.dfra.core.behavior.GoalProgress;
import org.dfra.core.module.ModuleImpl;
import org.dfra.recruit.agent.BodyModules.Homing;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** A new process of an agent moves nothing before it has asked all that may have been stopped. */
class RestartedAgentTest extends BodyFixture {

  private final List<ModuleRobotPort> dead = new ArrayList<>();

  @AfterEach
  void endTheDead() {
    dead.forEach(ModuleRobotPort::close);
  }

  /** The agent's process is killed, and another finds all modules of the robot but that. */
  private void restartWithout(ModuleImpl hidden) {
    dead.add(body); // what drives the robot does not end with it
    modules.hide(hidden);
    body = body();
  }

  private boolean isFree() {
    position.see(0, 0);
    modules.step(0.1);
    return body.isAvailable();
  }

  @Test
  void aLegStopsUntilItIsKnownWhetherSomebodyPausedTheSearchMeanwhile() throws RemoteException {
    UUID unused = search.pursue(FIELD);
    modules.step(1);
    body.travelTo(CALL, Long.MAX_VALUE, new NoJourney());
    modules.step(1);
    restartWithout(search);
    search.pause();
    body.travelTo(CALL, Long.MAX_VALUE, journey);
    modules.step(0.6);
    assertThat(driver.status().phase()).as("the leg").isEqualTo(Phase.CANCELLED);
    assertThat(reports).as("it waits").isEmpty();
    modules.show(search);
    modules.step(1);
    assertThat(driver.status().phase()).isEqualTo(Phase.CANCELLED);
    assertThat(reports).hasSize(1);
  }

  @Test
  void aLegGoesOnWithinASecondWhereNobodyStoppedAnything() throws RemoteException {
    UUID unused = search.pursue(FIELD);
    modules.step(1);
    body.travelTo(CALL, Long.MAX_VALUE, new NoJourney());
    modules.step(1);
    restartWithout(search);
    body.travelTo(CALL, Long.MAX_VALUE, journey);
    modules.step(0.6);
    assertThat(driver.status().phase()).isEqualTo(Phase.CANCELLED);
    modules.show(search);
    modules.step(1);
    assertThat(driver.status().phase()).isEqualTo(Phase.RUNNING);
    assertThat(reports).isEmpty();
  }

  @Test
  void noLegBeginsBeforeItIsKnownWhetherSomebodyStoppedTheRobot() throws RemoteException {
    Homing homing = modules.add(new Homing(modules.context("return_home")));
    modules.step(1);
    body.close();
    restartWithout(homing);
    UUID unused = homing.pursue(new HomeGoal(1));
    homing.pause();
    assertThat(isFree()).as("it answers no call").isFalse();
    body.travelTo(CALL, Long.MAX_VALUE, journey);
    modules.step(3);
    assertThat(driver.goal).isNull();
    modules.show(homing);
    modules.step(1);
    assertThat(driver.goal).isNull();
    assertThat(reports).hasSize(1);
    assertThat(reports.get(0)).contains("ugv1/return_home");
  }

  @Test
  void itStaysAndSaysSoWhereABehaviourOfItIsNotFoundInTime() throws RemoteException {
    body.close();
    restartWithout(search);
    body.travelTo(CALL, Long.MAX_VALUE, journey);
    modules.step(9);
    assertThat(reports).isEmpty();
    modules.step(2);
    assertThat(driver.goal).isNull();
    assertThat(reports).hasSize(1);
    assertThat(reports.get(0)).contains("ugv1/raster_search", "./dfra recruit resume ugv1");
    body.resumeOwnWork();
    modules.step(0.1);
    assertThat(body.holdReason()).isPresent();
    assertThat(isFree()).isFalse();
    body.endHold();
    modules.step(1);
    assertThat(isFree()).as("a person says that it may move").isTrue();
    body.close();
    body = body();
    assertThat(isFree()).as("what was removed is not missed again").isTrue();
    modules.show(search);
  }

  @Test
  void itNamesTheBehaviourThatDoesNotAnswerAndWhatToDo() {
    UUID id = UUID.randomUUID();
    body.close();
    modules.list(id, "return_home", BodyModules.stub(ReturnHome.class, () -> {}));
    body = body();
    body.travelTo(CALL, Long.MAX_VALUE, journey);
    modules.step(9);
    assertThat(reports).isEmpty();
    modules.step(2);
    assertThat(reports).hasSize(1);
    assertThat(reports.get(0))
        .contains("ugv1/return_home does not answer", "./dfra module kill ugv1/return_home");
    assertThat(body.holdReason()).hasValue(reports.get(0));
    modules.directory.remove(id);
    assertThat(body.holdReason().orElseThrow()).contains("does not find ugv1/return_home");
    Homing again = modules.add(new Homing(modules.context("return_home")));
    modules.step(1);
    assertThat(body.holdReason()).as("it answers").isEmpty();
    assertThat(again.goal).isNull();
  }

  @Test
  void aSearchThatItLeftDoesNotGoOnBeforeThat() throws RemoteException {
    Homing homing = modules.add(new Homing(modules.context("return_home")));
    UUID unused = search.pursue(FIELD);
    modules.step(1);
    body.travelTo(CALL, Long.MAX_VALUE, new NoJourney());
    modules.step(1);
    body.close();
    restartWithout(homing);
    body.resumeOwnWork(); // it does not help any more
    modules.step(2);
    assertThat(search.status().phase()).isEqualTo(Phase.PAUSED);
    modules.show(homing);
    modules.step(2);
    assertThat(search.status().phase()).isEqualTo(Phase.RUNNING);
  }

  /** Nor where a person says that it may help again: that moves nothing. */
  @Test
  void aSearchThatItLeftIsLeftToPeopleWhereOneEndsTheHold() throws RemoteException {
    Homing homing = modules.add(new Homing(modules.context("return_home")));
    UUID unused = search.pursue(FIELD);
    modules.step(1);
    body.travelTo(CALL, Long.MAX_VALUE, new NoJourney());
    modules.step(1);
    body.close();
    restartWithout(homing);
    body.resumeOwnWork();
    modules.step(11);
    assertThat(body.holdReason()).isPresent();
    body.endHold();
    modules.step(2);
    assertThat(search.status().phase()).isEqualTo(Phase.PAUSED);
    assertThat(body.holdReason()).isEmpty();
    modules.show(homing);
  }

  /** It may have been asked to come before its process died. */
  @Test
  void aLegThatWaitsIsGivenUpWhereAPersonEndsTheHold() throws RemoteException {
    UUID unused = search.pursue(FIELD);
    modules.step(1);
    body.travelTo(CALL, Long.MAX_VALUE, new NoJourney());
    modules.step(1);
    restartWithout(search);
    body.travelTo(CALL, Long.MAX_VALUE, journey);
    modules.step(1);
    assertThat(reports).as("it waits").isEmpty();
    body.endHold();
    modules.show(search);
    modules.step(2);
    assertThat(driver.status().phase()).as("nothing moves").isEqualTo(Phase.CANCELLED);
    assertThat(reports).hasSize(1);
    assertThat(reports.get(0)).contains("waits for the next call");
    body.resumeOwnWork();
    modules.step(2);
    assertThat(search.status().phase()).isEqualTo(Phase.PAUSED);
    search.resume();
    modules.step(1);
    body.travelTo(CALL, Long.MAX_VALUE, journey);
    modules.step(1);
    assertThat(driver.status().phase()).as("the next call").isEqualTo(Phase.RUNNING);
  }

  /** What drives the leg of the dead process is not found either. */
  @Test
  void aLegThatIsNotFoundYetIsEndedWhereAPersonEndsTheHold() {
    body.travelTo(CALL, Long.MAX_VALUE, new NoJourney());
    modules.step(1);
    restartWithout(driver);
    body.travelTo(CALL, Long.MAX_VALUE, journey);
    modules.step(1);
    body.endHold();
    assertThat(reports).hasSize(1);
    modules.show(driver);
    modules.step(2);
    assertThat(driver.status().phase()).isEqualTo(Phase.CANCELLED);
  }

  /** A behaviour held it when its agent started, so the agent had not asked all of them. */
  @Test
  void whereAPersonEndedTheHoldTheSearchGoesOnAfterTheNextTrip() throws RemoteException {
    UUID unused = search.pursue(FIELD);
    modules.step(1);
    search.pause();
    modules.step(1);
    body.close();
    body = body();
    body.resumeOwnWork(); // as an agent does that does not help
    modules.step(2);
    body.endHold();
    search.resume();
    modules.step(1);
    body.travelTo(CALL, Long.MAX_VALUE, journey);
    modules.step(1);
    assertThat(search.status().phase()).isEqualTo(Phase.PAUSED);
    driver.progress = GoalProgress.reached("it is there");
    modules.step(1);
    assertThat(reports).containsExactly("arrived");
    body.resumeOwnWork();
    modules.step(2);
    assertThat(search.status().phase()).isEqualTo(Phase.RUNNING);
  }

  /** Its dead process was of a version that did not write down which modules its robot has. */
  @ParameterizedTest
  @ValueSource(booleans = {false, true})
  void afterAnUpgradeWhatItLeftWaitsUntilItHasLookedForLongEnough(boolean isStopped)
      throws IOException {
    Homing homing = modules.add(new Homing(modules.context("return_home")));
    UUID unused = search.pursue(FIELD);
    modules.step(1);
    body.travelTo(CALL, Long.MAX_VALUE, new NoJourney());
    modules.step(1);
    body.close();
    modules.context("agent").state().write("hold", new byte[0]);
    restartWithout(homing);
    if (isStopped) {
      UUID home = homing.pursue(new HomeGoal(1));
      homing.pause();
      assertThat(homing.status().goal()).isEqualTo(home);
    }
    body.resumeOwnWork();
    modules.step(5);
    assertThat(search.status().phase()).isEqualTo(Phase.PAUSED);
    assertThat(isFree()).as("it answers no call").isFalse();
    modules.show(homing);
    modules.step(4);
    assertThat(search.status().phase()).isEqualTo(Phase.PAUSED);
    modules.step(3);
    assertThat(search.status().phase()).isEqualTo(isStopped ? Phase.PAUSED : Phase.RUNNING);
  }

  /** The listener of a process that is dead. */
  private static final class NoJourney implements RobotPort.TravelListener {
    @Override
    public void arrived() {}

    @Override
    public void failed(String why) {}
  }
}
