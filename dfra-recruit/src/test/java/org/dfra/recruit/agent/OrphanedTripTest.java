package org.dfra.recruit.agent;

import static org.assertj.core.api.Assertions.assertThat;
import static org.dfra.recruit.agent.BodyModules.at;

import java.io.IOException;
import java.lang.reflect.Proxy;
import java.rmi.RemoteException;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.UUID;
import org.dfra.agent.HelpCall;
import org.dfra.behavior.BehaviorStatus.Phase;
import org.dfra.behavior.LegGoal;
import org.dfra.core.behavior.GoalProgress;
import org.dfra.core.state.StateStore;
import org.dfra.flow.effector.DriveEffector;
import org.dfra.flow.effector.EmergencyStopState;
import org.dfra.lifecycle.Readiness;
import org.dfra.recruit.agent.BodyModules.Driver;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** What an agent's next process does with a trip that its dead one began. */
class OrphanedTripTest extends BodyFixture {

  private final List<ModuleRobotPort> dead = new ArrayList<>(); // may do nothing any more

  @AfterEach
  void endTheDead() {
    dead.forEach(ModuleRobotPort::close);
  }

  /** The agent's process dies, and what drives does not; reports of the dead one are ignored. */
  private UUID bereave() {
    body.travelTo(
        CALL,
        Long.MAX_VALUE,
        new RobotPort.TravelListener() {
          @Override
          public void arrived() {}

          @Override
          public void failed(String why) {}
        });
    modules.step(1);
    dead.add(body);
    body = body();
    return Objects.requireNonNull(driver.status().goal());
  }

  @Test
  void whatItsDeadProcessHasBegunIsFollowed() {
    UUID goal = bereave();
    body.travelTo(CALL, Long.MAX_VALUE, journey);
    modules.step(3);
    assertThat(driver.status().goal()).as("it continues").isEqualTo(goal);
    assertThat(driver.status().phase()).isEqualTo(Phase.RUNNING);
    driver.progress = GoalProgress.reached("it is there");
    modules.step(1);
    assertThat(reports).containsExactly("arrived");
    assertThat(driver.status().goal()).isEqualTo(goal);
  }

  @Test
  void whatSomebodyStoppedWhileItWasDeadIsNotRestarted() throws RemoteException {
    for (boolean isPaused : List.of(true, false)) {
      UUID raster = search.pursue(FIELD);
      modules.step(1);
      UUID goal = bereave();
      if (isPaused) {
        driver.pause();
      } else {
        driver.cancel();
      }
      modules.hide(driver); // in a new process nothing is found at first
      reports.clear();
      body.travelTo(CALL, Long.MAX_VALUE, journey);
      modules.step(2);
      modules.show(driver);
      modules.step(2);
      assertThat(reports).hasSize(1).doesNotContain("arrived");
      assertThat(driver.status().goal()).as("no goal is started").isEqualTo(goal);
      assertThat(driver.status().phase()).isEqualTo(Phase.CANCELLED);
      body.resumeOwnWork();
      modules.step(3);
      assertThat(search.status().phase()).isEqualTo(Phase.PAUSED);
      search.cancel(raster);
    }
  }

  /** Nobody knows any more to whom it has promised to come. */
  @Test
  void anAgentThatCannotReadWhatItKeptStopsItsRobotAndResumesNothing() throws IOException {
    UUID unused = search.pursue(FIELD);
    modules.step(1);
    body.travelTo(CALL, Long.MAX_VALUE, journey);
    modules.step(1);
    assertThat(driver.status().phase()).isEqualTo(Phase.RUNNING);
    modules.context("agent").state().write("recruitment", new byte[] {1, 2, 3});
    try (RecruitmentAgentImpl agent = new RecruitmentAgentImpl(modules.context("agent"))) {
      agent.start();
      modules.step(3);
      assertThat(agent.readiness()).isEqualTo(Readiness.FAILED);
      assertThat(driver.status().phase()).isEqualTo(Phase.CANCELLED);
      assertThat(search.status().phase()).isEqualTo(Phase.PAUSED);
    }
  }

  @Test
  void nothingGoesOnBeforeItIsKnownWhetherSomebodyHasStoppedIt() throws RemoteException {
    UUID raster = search.pursue(FIELD);
    modules.step(1);
    UUID unused = bereave();
    driver.pause();
    modules.hide(driver);
    body.resumeOwnWork(); // it does not help any more
    modules.step(3);
    assertThat(search.status().phase()).isEqualTo(Phase.PAUSED);
    modules.show(driver);
    modules.step(3);
    assertThat(search.status().phase()).isEqualTo(Phase.PAUSED);
    assertThat(search.status().goal()).isEqualTo(raster);
  }

  /** The agent dies, the wheels are stopped and released, and what drove them has died too. */
  @Test
  void aTripWhoseWheelsWereStoppedMeanwhileIsNotRestarted() {
    StoppedDrive wheels = new StoppedDrive(modules);
    UUID unused = bereave();
    modules.end(driver);
    modules.step(1);
    wheels.stop =
        new EmergencyStopState(false, "a test", modules.time.instant(), true, null); // released
    Driver again = modules.add(new Driver(modules.context("go_to_waypoint")));
    body.travelTo(CALL, Long.MAX_VALUE, journey);
    modules.step(3);
    assertThat(reports)
        .containsExactly("it was stopped for an emergency after it was asked to come");
    assertThat(again.goal).as("no goal is started").isNull();
    reports.clear();
    body.travelTo(CALL, Long.MAX_VALUE, journey); // asked again
    modules.step(1);
    assertThat(reports).isEmpty();
    assertThat(again.status().phase()).isEqualTo(Phase.RUNNING);
  }

  /** Agent, wheels and what drives them have died, and the wheels are found last. */
  @Test
  void aTripIsNotRestartedBeforeItsWheelsAreFoundAgain() throws IOException {
    StoppedDrive wheels = new StoppedDrive(modules);
    modules.step(1);
    body.travelTo(CALL, Long.MAX_VALUE, journey);
    modules.step(1);
    StateStore kept = modules.context("agent").state();
    byte[] trip = kept.read("trip").orElseThrow();
    modules.end(driver);
    body.close();
    kept.write("trip", trip); // as where its process is killed
    wheels.hide();
    wheels.stop =
        new EmergencyStopState(false, "a test", modules.time.instant(), true, null); // released
    Driver next = modules.add(new Driver(modules.context("go_to_waypoint")));
    body = body();
    body.travelTo(CALL, Long.MAX_VALUE, journey);
    modules.step(3);
    assertThat(next.goal).as("no goal is started").isNull();
    assertThat(reports).as("it waits").isEmpty();
    wheels.show();
    modules.step(1);
    assertThat(next.goal).as("no goal is started").isNull();
    assertThat(reports)
        .containsExactly("it was stopped for an emergency after it was asked to come");
  }

  @Test
  void aLegThatWasLostIsRestartedUnlessTheWheelsWereStoppedSince() throws RemoteException {
    StoppedDrive wheels = new StoppedDrive(modules);
    wheels.stop = new EmergencyStopState(false, "a test", modules.time.instant(), true, null);
    modules.step(1);
    body.travelTo(CALL, Long.MAX_VALUE, journey);
    modules.step(1);
    LegGoal own = Objects.requireNonNull(driver.goal);
    Driver second = restarted(driver);
    modules.step(1);
    assertThat(second.goal).as("not stopped since").isEqualTo(own);
    assertThat(second.status().phase()).isEqualTo(Phase.RUNNING);
    Driver third = restarted(second);
    wheels.stop = new EmergencyStopState(false, "a test", modules.time.instant(), true, null);
    modules.step(1);
    assertThat(third.goal).as("it is not restarted").isNull();
    assertThat(reports).hasSize(1);
  }

  /** The wheels say when they were stopped by a clock that was set after the agent was asked. */
  @Test
  void anEmergencyStopIsNoticedThoughTheClockWasSetBackBeforeIt() {
    StoppedDrive wheels = new StoppedDrive(modules);
    body.travelTo(CALL, Long.MAX_VALUE, journey);
    modules.step(1);
    modules.set = Duration.ofHours(-1);
    Driver next = restarted(driver);
    wheels.stop = new EmergencyStopState(false, "a test", modules.wall(), true, null);
    modules.step(1);
    assertThat(next.goal).as("it is not restarted").isNull();
    assertThat(reports)
        .containsExactly("it was stopped for an emergency after it was asked to come");
  }

  /** So is the other way round: what was before the agent was asked does not count. */
  @ParameterizedTest
  @ValueSource(booleans = {false, true})
  void anEarlierEmergencyStopDoesNotCountThoughTheClockWasSetBackAfterIt(boolean isOrphaned) {
    StoppedDrive wheels = new StoppedDrive(modules);
    wheels.stop = new EmergencyStopState(false, "a test", modules.wall(), true, null);
    modules.step(1);
    modules.set = Duration.ofHours(-1);
    if (isOrphaned) {
      UUID unused = bereave();
    }
    body.travelTo(CALL, Long.MAX_VALUE, journey);
    modules.step(1);
    assertThat(reports).isEmpty();
    assertThat(driver.status().phase()).isEqualTo(Phase.RUNNING);
    LegGoal own = driver.goal;
    modules.set = Duration.ofHours(1);
    Driver next = restarted(driver);
    modules.step(1);
    assertThat(next.goal).as("not stopped since").isEqualTo(own);
  }

  /** The process that drives dies, and there is another. */
  private Driver restarted(Driver dead) {
    modules.end(dead);
    return modules.add(new Driver(modules.context("go_to_waypoint")));
  }

  /** Between the death of what drives and the next time that the agent checks it. */
  @Test
  void aLegThatSomebodyStoppedAfterItsProcessDiedIsNotRestarted() throws RemoteException {
    Driver last = driver;
    for (boolean isPaused : List.of(true, false)) {
      reports.clear();
      body.endHold();
      body.travelTo(CALL, Long.MAX_VALUE, journey);
      modules.step(1);
      last = restarted(last);
      if (isPaused) {
        last.pause();
      } else {
        last.cancel();
      }
      modules.step(3);
      assertThat(last.goal).as("no goal is started").isNull();
      assertThat(last.status().phase()).isEqualTo(Phase.CANCELLED);
      assertThat(reports).hasSize(1);
      body.resumeOwnWork();
      modules.step(0.1);
      assertThat(body.isAvailable()).as("it answers no call").isFalse();
    }
  }

  /** It was stopped, and died before the agent checked it. */
  @Test
  void aLegThatSomebodyStoppedBeforeItsProcessDiedIsNotRestarted() throws RemoteException {
    Driver last = driver;
    for (boolean isPaused : List.of(true, false)) {
      reports.clear();
      body.endHold();
      body.travelTo(CALL, Long.MAX_VALUE, journey);
      modules.step(1);
      if (isPaused) {
        last.pause();
      } else {
        last.cancel();
      }
      last = restarted(last);
      modules.step(3);
      assertThat(last.goal).as("no goal is started").isNull();
      assertThat(reports).hasSize(1);
      body.resumeOwnWork();
      modules.step(0.1);
      assertThat(body.isAvailable()).as("it answers no call").isFalse();
    }
  }

  @Test
  void aLegOfWhichNobodyKnowsWhetherItWasStoppedIsNotRestarted() {
    body.travelTo(CALL, Long.MAX_VALUE, journey);
    modules.step(1);
    modules.end(driver);
    modules.forget("go_to_waypoint"); // its disk was lost
    Driver next = modules.add(new Driver(modules.context("go_to_waypoint")));
    modules.step(3);
    assertThat(next.goal).as("no goal is started").isNull();
    assertThat(reports)
        .containsExactly(
            "the behaviour that drives it lost its leg, so it is unknown whether the robot was stopped");
    body.resumeOwnWork();
    modules.step(1);
    assertThat(body.holdReason()).isPresent();
    body.close();
    body = body();
    assertThat(body.holdReason()).as("the next process knows it too").isPresent();
    body.endHold();
    assertThat(body.holdReason()).isEmpty();
  }

  /** Wheels of which only their emergency stop is asked. */
  private static final class StoppedDrive {

    private final BodyModules modules;
    private final UUID id = UUID.randomUUID();
    private final DriveEffector drive;
    private volatile EmergencyStopState stop = EmergencyStopState.NEVER;

    StoppedDrive(BodyModules modules) {
      this.modules = modules;
      this.drive =
          (DriveEffector)
              Proxy.newProxyInstance(
                  DriveEffector.class.getClassLoader(),
                  new Class<?>[] {DriveEffector.class},
                  (proxy, method, args) ->
                      switch (method.getName()) {
                        case "equals" -> proxy == args[0];
                        case "hashCode" -> 1;
                        case "emergencyStopState" -> stop;
                        default -> throw new AssertionError(method);
                      });
      show();
    }

    void show() {
      modules.list(id, "drive", drive);
    }

    void hide() {
      modules.directory.remove(id);
    }
  }

  @Test
  void whatItsDeadProcessHasBegunIsCalledOff() {
    UUID goal = bereave();
    body.travelTo(CALL, Long.MAX_VALUE, journey);
    modules.step(1);
    body.resumeOwnWork();
    modules.step(1);
    assertThat(driver.status().goal()).isEqualTo(goal);
    assertThat(driver.status().phase()).isEqualTo(Phase.CANCELLED);
  }

  @Test
  void whatItsDeadProcessHasBegunEndsAsSoonAsItIsFoundWhereItHelpsNobody() {
    UUID goal = bereave();
    modules.hide(driver);
    body.resumeOwnWork();
    modules.step(1);
    assertThat(driver.status().phase()).isEqualTo(Phase.RUNNING);
    modules.show(driver);
    modules.step(1);
    assertThat(driver.status().goal()).isEqualTo(goal);
    assertThat(driver.status().phase()).isEqualTo(Phase.CANCELLED);
  }

  @Test
  void whatItsDeadProcessHasBegunEndsWhereItIsCalledElsewhere() {
    UUID goal = bereave();
    HelpCall other =
        new HelpCall("mine", at(5, 5), Duration.ofSeconds(20), Duration.ofSeconds(100));
    body.travelTo(other, Long.MAX_VALUE, journey);
    modules.step(2);
    assertThat(driver.goal).isEqualTo(new LegGoal(null, other.position(), 0.7));
    assertThat(driver.status().goal()).isNotEqualTo(goal);
    assertThat(driver.status().phase()).isEqualTo(Phase.RUNNING);
  }

  @Test
  void whatSomebodyElseBeganSinceIsLeftAlone() throws RemoteException {
    UUID unused = bereave();
    driver.cancel();
    UUID others = driver.pursue(new LegGoal(null, at(1, 1), 1));
    body.resumeOwnWork();
    modules.step(2);
    assertThat(driver.status().goal()).isEqualTo(others);
    assertThat(driver.status().phase()).isEqualTo(Phase.RUNNING);
  }
}
