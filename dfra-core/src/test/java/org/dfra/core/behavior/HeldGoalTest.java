package org.dfra.core.behavior;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import java.rmi.RemoteException;
import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.util.Map;
import java.util.UUID;
import org.dfra.behavior.BehaviorStatus;
import org.dfra.behavior.BehaviorStatus.Phase;
import org.dfra.behavior.Goal;
import org.dfra.core.config.Parameters;
import org.dfra.core.module.ModuleContext;
import org.dfra.core.state.StateStore;
import org.dfra.flow.effector.BrakeEngagedException;
import org.dfra.flow.effector.CommandRefusedByEmergencyStopException;
import org.dfra.persona.BehaviorAttributes;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** What a behaviour says and remembers of a goal that somebody has stopped. */
@Timeout(60)
class HeldGoalTest {

  private record Place(String name) implements Goal {}

  private final StateStore state = StateStore.inMemory();
  private volatile @Nullable RuntimeException obstacle;
  private Walker walker = new Walker();

  private final class Walker extends BehaviorImpl<Place> {

    Walker() {
      super(
          new ModuleContext(
              "atrv1",
              "walker",
              Parameters.of("atrv1/walker", Map.of("rate", "50")),
              InstantSource.system(),
              state),
          "walks",
          "DFRA",
          "1",
          Place.class,
          10);
    }

    @Override
    protected GoalExecution startGoal(Place goal) {
      return new GoalExecution() {
        @Override
        public GoalProgress step() {
          @Nullable RuntimeException now = obstacle;
          if (now != null) {
            throw now;
          }
          return GoalProgress.inProgress("it walks", 0);
        }

        @Override
        public void suspend() {}
      };
    }
  }

  @BeforeEach
  void start() {
    walker.start();
  }

  @AfterEach
  void end() {
    walker.close();
  }

  /** Its process dies, and there is another. */
  private void restart() {
    walker.close();
    walker = new Walker();
    walker.start();
  }

  private BehaviorStatus status() {
    return walker.status();
  }

  @Test
  void aGoalIsHeldWhereAPersonPausesOrCancelsIt() throws RemoteException {
    UUID goal = walker.pursue(new Place("home"));
    assertThat(status().heldSince()).isNull();
    walker.pauseUnattended();
    assertThat(status().heldSince()).as("a program may have it go on").isNull();
    walker.pause();
    @Nullable Instant first = status().heldSince();
    assertThat(first).isNotNull();
    assertThat(walker.attributes())
        .contains(new BehaviorAttributes("Place", false, "PAUSED", 50, first));
    walker.resumeUnattended();
    assertThat(status().phase()).isEqualTo(Phase.PAUSED);
    walker.cancelUnattended(goal);
    assertThat(status().phase()).isEqualTo(Phase.CANCELLED);
    assertThat(status().heldSince()).as("a program does not let it go on").isEqualTo(first);
    goal = walker.pursueUnattended(new Place("home"));
    assertThat(status().heldSince()).isNull();
    walker.cancelUnattended(goal);
    assertThat(status().heldSince()).isNull();
    goal = walker.pursue(new Place("home"));
    walker.cancel(goal);
    assertThat(status().heldSince()).isNotNull();
  }

  @Test
  void aGoalIsHeldWhereABrakeOrAnEmergencyStopsIt() throws RemoteException {
    UUID unused = walker.pursue(new Place("home"));
    obstacle = new BrakeEngagedException("its brake is set");
    await().until(() -> status().phase() == Phase.PAUSED);
    assertThat(status().heldSince()).isNotNull();
    obstacle = null;
    walker.resume();
    assertThat(status().heldSince()).isNull();
    obstacle = new DelegateHeldException("its leg was stopped");
    await().until(() -> status().phase() == Phase.PAUSED);
    assertThat(status().heldSince()).isNotNull();
    obstacle = null;
    walker.resume();
    obstacle = new CommandRefusedByEmergencyStopException("it is stopped");
    await().until(() -> status().phase() == Phase.CANCELLED);
    assertThat(status().heldSince()).isNotNull();
  }

  @Test
  void theNextProcessKnowsThatItsGoalWasLostAndNotStopped() throws RemoteException {
    UUID goal = walker.pursue(new Place("home"));
    restart();
    assertThat(status().goal()).isEqualTo(goal);
    assertThat(status().phase()).isEqualTo(Phase.IDLE);
    assertThat(status().heldSince()).isNull();
    assertThat(Duration.between(status().measured(), Instant.now()))
        .isLessThan(Duration.ofHours(1));
  }

  @Test
  void theNextProcessKnowsThatSomebodyHadStoppedIt() throws RemoteException {
    for (boolean isPaused : new boolean[] {true, false}) {
      UUID goal = walker.pursue(new Place("home"));
      if (isPaused) {
        walker.pause();
      } else {
        walker.cancel();
      }
      @Nullable Instant since = status().heldSince();
      restart();
      assertThat(status().goal()).isEqualTo(goal);
      assertThat(status().phase()).isEqualTo(Phase.CANCELLED);
      assertThat(status().heldSince()).isEqualTo(since);
    }
  }

  @Test
  void aStopOfAGoalWhoseProcessHasDiedIsRemembered() throws RemoteException {
    for (int way = 0; way < 3; way++) {
      UUID goal = walker.pursue(new Place("home"));
      restart();
      switch (way) {
        case 0 -> walker.pause();
        case 1 -> walker.cancel();
        default -> walker.cancel(goal);
      }
      assertThat(status().goal()).isEqualTo(goal);
      assertThat(status().phase()).isEqualTo(Phase.CANCELLED);
      assertThat(status().heldSince()).isNotNull();
    }
  }
}
