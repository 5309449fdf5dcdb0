package org.dfra.recruit.agent;

import static org.assertj.core.api.Assertions.assertThat;
import static org.dfra.recruit.agent.BodyModules.at;

import java.rmi.RemoteException;
import java.time.Duration;
import java.time.InstantSource;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.UUID;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.atomic.AtomicReference;
import org.dfra.agent.ResponderPhase;
import org.dfra.behavior.BehaviorStatus.Phase;
import org.dfra.behavior.LegGoal;
import org.dfra.behavior.RasterSearch;
import org.dfra.core.behavior.GoalProgress;
import org.dfra.core.config.Parameters;
import org.dfra.core.module.ModuleContext;
import org.dfra.recruit.agent.BodyModules.Driver;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.slf4j.LoggerFactory;

/** What an agent knows of its robot and has it do, by the robot's own modules. */
class ModuleRobotPortTest extends BodyFixture {

  @Test
  void theTimeToAPlaceIsThatOfItsWayAtItsSpeed() {
    // 50 m as the crow flies, a fifth more to drive, half a metre in a second.
    assertThat(body.eta(CALL.position()).orElseThrow()).isBetween(millis(119_900), millis(120_100));
    position.see(30, 20);
    modules.step(0.1);
    assertThat(body.eta(CALL.position()).orElseThrow()).isBetween(millis(47_950), millis(48_050));
    assertThat(body.canObserve("mine")).isTrue();
    assertThat(body.canObserve("heat")).isFalse();
    assertThat(body.isInField(at(99, 49))).isTrue();
    assertThat(body.isInField(at(99, 51))).isFalse();
  }

  private static Duration millis(long all) {
    return Duration.ofMillis(all);
  }

  @Test
  void itGoesThereAndReportsItsArrivalOnce() {
    body.travelTo(CALL, Long.MAX_VALUE, journey);
    modules.step(1);
    assertThat(driver.goal).isEqualTo(new LegGoal(null, CALL.position(), 0.7));
    assertThat(driver.status().phase()).isEqualTo(Phase.RUNNING);
    assertThat(reports).isEmpty();
    driver.progress = GoalProgress.reached("it is there");
    modules.step(5);
    assertThat(reports).containsExactly("arrived");
    body.observe(CALL);
    body.resumeOwnWork();
    modules.step(5);
    assertThat(reports).containsExactly("arrived");
    assertThat(driver.status().phase()).isEqualTo(Phase.SUCCEEDED);
  }

  @Test
  void whatDrivesItLearnsWhenItsLeaseOfTheTaskEnds() {
    body.travelTo(CALL, modules.time.nanos() + 20_000_000_000L, journey);
    modules.step(1);
    LegGoal goal = (LegGoal) Objects.requireNonNull(driver.goal);
    assertThat(goal.timeLimit()).isBetween(Duration.ofSeconds(18), Duration.ofSeconds(20));
  }

  @Test
  void aLongerLeaseOfTheTaskReachesWhatDrivesWithoutAStop() {
    body.travelTo(CALL, modules.time.nanos() + 20_000_000_000L, journey);
    modules.step(1);
    UUID leg = Objects.requireNonNull(driver.status().goal());
    body.extendLease(modules.time.nanos() + 60_000_000_000L);
    modules.step(0.1);
    assertThat(driver.limit).isBetween(Duration.ofSeconds(59), Duration.ofSeconds(60));
    modules.step(30);
    assertThat(driver.status().goal()).as("the same leg").isEqualTo(leg);
    assertThat(driver.status().phase()).isEqualTo(Phase.RUNNING);
    assertThat(reports).isEmpty();
  }

  /** As that of a process that was suspended. */
  @Test
  void onceItsLeaseOfTheTaskIsOverItDoesNotBeginToMove() {
    body.travelTo(CALL, modules.time.nanos() - 1, journey);
    modules.step(5);
    assertThat(driver.goal).isNull();
    assertThat(reports).containsExactly("its lease of the task has ended");
  }

  @Test
  void itReportsWhyItWillNotGetThere() {
    body.travelTo(CALL, Long.MAX_VALUE, journey);
    modules.step(1);
    driver.progress = GoalProgress.failed("an obstacle is in the way", 0.5);
    modules.step(5);
    assertThat(reports).containsExactly("an obstacle is in the way");
  }

  @Test
  void itWillNotGetThereWhereItsLegIsPausedAsByABrake() {
    body.travelTo(CALL, Long.MAX_VALUE, journey);
    modules.step(1);
    assertThat(driver.attended).as("no brake is released for others").containsExactly(false);
    driver.progress = GoalProgress.paused("ugv1/drive has its brake set", 0.5);
    modules.step(5);
    assertThat(reports).containsExactly("ugv1/drive has its brake set");
    assertThat(driver.status().phase()).isEqualTo(Phase.CANCELLED);
    driver.resume();
    modules.step(1);
    assertThat(driver.status().phase()).isEqualTo(Phase.CANCELLED);
  }

  @Test
  void onceCalledOffItStopsAndReportsNothing() {
    body.travelTo(CALL, Long.MAX_VALUE, journey);
    modules.step(1);
    body.resumeOwnWork();
    modules.step(1);
    assertThat(driver.status().phase()).isEqualTo(Phase.CANCELLED);
    modules.step(5);
    assertThat(reports).isEmpty();
  }

  @Test
  void itSetsOutAsSoonAsThereIsSomethingThatDrives() {
    modules.end(driver);
    body.travelTo(CALL, Long.MAX_VALUE, journey);
    modules.step(3);
    assertThat(reports).as("it waits").isEmpty();
    Driver again = modules.add(new Driver(modules.context("go_to_waypoint")));
    modules.step(2);
    assertThat(again.status().phase()).isEqualTo(Phase.RUNNING);
  }

  @Test
  void itWaitsForItsWheelsWhereSomebodyElseHasTakenThem() throws RemoteException {
    UUID unused = driver.pursue(new LegGoal(null, at(1, 1), 1));
    body.travelTo(CALL, Long.MAX_VALUE, journey);
    modules.step(3);
    assertThat(driver.goal).isEqualTo(new LegGoal(null, at(1, 1), 1));
    assertThat(reports).isEmpty();
    driver.progress = GoalProgress.reached("it is there");
    modules.step(1);
    assertThat(driver.goal).isEqualTo(new LegGoal(null, CALL.position(), 0.7));
    assertThat(driver.status().phase()).isEqualTo(Phase.RUNNING);
  }

  @Test
  void itGoesNoFartherWhereSomebodyElseTakesItsWheelsOnTheWay() throws RemoteException {
    body.travelTo(CALL, Long.MAX_VALUE, journey);
    modules.step(1);
    driver.cancel();
    UUID others = driver.pursue(new LegGoal(null, at(1, 1), 1));
    modules.step(1);
    assertThat(reports).containsExactly("the behaviour that drives it was given another goal");
    driver.progress = GoalProgress.reached("it is there");
    modules.step(3);
    assertThat(driver.status().goal()).isEqualTo(others);
  }

  @Test
  void itLeavesItsSearchAndGoesOnWithIt() throws RemoteException {
    UUID goal = search.pursue(FIELD);
    modules.step(1);
    assertThat(body.hasOwnWork()).isTrue();
    body.travelTo(CALL, Long.MAX_VALUE, journey);
    modules.step(1);
    assertThat(search.status().phase()).isEqualTo(Phase.PAUSED);
    assertThat(body.hasOwnWork()).isFalse();
    body.resumeOwnWork();
    modules.step(1);
    assertThat(search.status().phase()).isEqualTo(Phase.RUNNING);
    assertThat(search.status().goal()).isEqualTo(goal);
    assertThat(search.attended).as("no brake is released by going on").containsExactly(true);
  }

  @Test
  void aSearchThatItsOperatorPausedStaysSo() throws RemoteException {
    UUID unused = search.pursue(FIELD);
    search.pause();
    body.travelTo(CALL, Long.MAX_VALUE, journey);
    modules.step(1);
    body.resumeOwnWork();
    modules.step(5);
    assertThat(search.status().phase()).isEqualTo(Phase.PAUSED);
  }

  @Test
  void aSearchThatItsOperatorPausesWhileItHelpsStaysSo() throws RemoteException {
    UUID unused = search.pursue(FIELD);
    modules.step(1);
    body.travelTo(CALL, Long.MAX_VALUE, journey);
    modules.step(1);
    search.pause();
    body.resumeOwnWork();
    modules.step(5);
    assertThat(search.status().phase()).isEqualTo(Phase.PAUSED);
  }

  /** Somebody stops it on its way, and steps in front of it. */
  @Test
  void aLegThatItsOperatorStopsDoesNotHaveItsSearchGoOn() throws RemoteException {
    UUID unused = search.pursue(FIELD);
    for (boolean isPaused : List.of(true, false)) {
      for (boolean isReleasedAtOnce : List.of(true, false)) {
        modules.step(1);
        assertThat(search.status().phase()).isEqualTo(Phase.RUNNING);
        reports.clear();
        body.travelTo(CALL, Long.MAX_VALUE, journey);
        modules.step(1);
        if (isPaused) {
          driver.pause();
        } else {
          driver.cancel();
        }
        if (!isReleasedAtOnce) {
          modules.step(1);
          assertThat(reports).hasSize(1);
        }
        body.resumeOwnWork(); // as the agent does, whose trip has failed, or which is called off
        modules.step(5);
        assertThat(search.status().phase()).isEqualTo(Phase.PAUSED);
        assertThat(driver.status().phase()).isEqualTo(Phase.CANCELLED);
        search.resume();
      }
    }
  }

  @Test
  void whatItLeftGoesOnThoughItsProcessHasDiedMeanwhile() throws RemoteException {
    UUID unused = search.pursue(FIELD);
    modules.step(1);
    body.travelTo(CALL, Long.MAX_VALUE, journey);
    modules.step(1);
    body.close();
    body = body();
    body.travelTo(CALL, Long.MAX_VALUE, journey); // it was on its way
    modules.step(1);
    assertThat(search.status().phase()).isEqualTo(Phase.PAUSED);
    body.resumeOwnWork();
    modules.step(1);
    assertThat(search.status().phase()).isEqualTo(Phase.RUNNING);
  }

  @Test
  void anAgentThatHelpsNobodyGoesOnWithWhatItLeftBeforeItDied() throws RemoteException {
    UUID unused = search.pursue(FIELD);
    modules.step(1);
    body.travelTo(CALL, Long.MAX_VALUE, journey);
    modules.step(1);
    body.close(); // after its release, and before its search was resumed
    assertThat(search.status().phase()).isEqualTo(Phase.PAUSED);
    RecruitmentAgentImpl agent = modules.add(new RecruitmentAgentImpl(modules.context("agent")));
    modules.step(2);
    assertThat(agent.status().responderPhase()).isEqualTo(ResponderPhase.FREE);
    assertThat(search.status().phase()).isEqualTo(Phase.RUNNING);
  }

  @Test
  void aSearchThatDidNotAnswerWaitsUntilItHelpsNobodyAgain() throws RemoteException {
    UUID unused = search.pursue(FIELD);
    modules.step(1);
    body.travelTo(CALL, Long.MAX_VALUE, journey);
    modules.step(1);
    modules.hide(search);
    body.resumeOwnWork();
    modules.step(0.1);
    body.travelTo(CALL, Long.MAX_VALUE, journey);
    modules.step(0.1);
    driver.progress = GoalProgress.reached("it is there");
    modules.show(search);
    modules.step(0.6);
    assertThat(reports).containsExactly("arrived");
    body.observe(CALL);
    modules.step(5);
    assertThat(search.status().phase()).as("it observes").isEqualTo(Phase.PAUSED);
    body.resumeOwnWork();
    modules.step(1);
    assertThat(search.status().phase()).isEqualTo(Phase.RUNNING);
  }

  @Test
  void aSearchThatWasNotFoundIsPausedWhereItHoldsWhatDrives() throws RemoteException {
    UUID unused = search.pursue(FIELD);
    UUID leg = driver.pursue(new LegGoal(null, at(1, 1), 1)); // the search's
    modules.step(1);
    modules.hide(search);
    body.travelTo(CALL, Long.MAX_VALUE, journey);
    modules.step(1);
    assertThat(driver.status().goal()).isEqualTo(leg);
    modules.show(search);
    modules.step(1);
    assertThat(search.status().phase()).isEqualTo(Phase.PAUSED);
    driver.cancelUnattended(leg); // as a search does that pauses
    modules.step(1);
    assertThat(driver.goal).isEqualTo(new LegGoal(null, CALL.position(), 0.7));
    body.resumeOwnWork();
    modules.step(1);
    assertThat(search.status().phase()).isEqualTo(Phase.RUNNING);
  }

  @Test
  void aSearchThatIsGoneDoesNotKeepItBusy() throws RemoteException {
    UUID unused = search.pursue(FIELD);
    modules.step(1);
    assertThat(body.hasOwnWork()).isTrue();
    modules.end(search); // without a word
    modules.step(1);
    assertThat(body.hasOwnWork()).isFalse();
  }

  /** A request from before its end takes long, and must not make the robot drive afterwards. */
  @Test
  @Timeout(60)
  void onceItHasEndedNothingDrives() throws InterruptedException {
    CountDownLatch asked = new CountDownLatch(1);
    CountDownLatch answers = new CountDownLatch(1);
    AtomicReference<Thread> asker = new AtomicReference<>();
    RasterSearch slow =
        BodyModules.stub(
            RasterSearch.class,
            () -> {
              asker.set(Thread.currentThread());
              asked.countDown();
              BodyModules.awaitAnyway(answers);
            });
    modules.list(UUID.randomUUID(), "slow_search", slow);
    ModuleRobotPort real =
        new ModuleRobotPort(
            new ModuleContext(
                    BodyModules.ROBOT,
                    "agent",
                    Parameters.of("ugv1/agent", Map.of()),
                    InstantSource.system())
                .withDirectory(modules.directory),
            TRAITS,
            LoggerFactory.getLogger("test"));
    real.travelTo(CALL, Long.MAX_VALUE, journey);
    asked.await();
    Thread closer = new Thread(real::close, "closer");
    closer.start();
    while (closer.getState() != Thread.State.TIMED_WAITING && closer.isAlive()) {
      Thread.yield(); // until it waits, or does not
    }
    answers.countDown();
    closer.join();
    asker.get().join();
    assertThat(driver.status().phase().isUnderWay()).isFalse();
  }
}
