package org.dfra.core.behavior;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.awaitility.Awaitility.await;

import java.lang.reflect.Proxy;
import java.rmi.RemoteException;
import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.util.List;
import java.util.Map;
import java.util.UUID;
import org.dfra.behavior.Behavior;
import org.dfra.behavior.BehaviorStatus;
import org.dfra.behavior.BehaviorStatus.Phase;
import org.dfra.behavior.Goal;
import org.dfra.core.chain.DelayedTaskExecutor;
import org.dfra.core.config.Parameters;
import org.dfra.core.directory.InMemoryModuleDirectory;
import org.dfra.core.module.ModuleContext;
import org.dfra.core.module.ModuleDependency;
import org.dfra.directory.Locality;
import org.dfra.lifecycle.Readiness;
import org.dfra.persona.ModuleAttributes;
import org.dfra.time.Scheduler;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.slf4j.LoggerFactory;

/** One behaviour has another work for it, over a network that loses answers. */
@Timeout(60)
class GoalDelegationTest {

  private static final Duration PATIENCE = Duration.ofSeconds(20);

  private record Wish() implements Goal {}

  private interface Worker extends Behavior<Wish> {}

  private final InMemoryModuleDirectory directory = new InMemoryModuleDirectory();
  private final DelayedTaskExecutor taskExecutor =
      new DelayedTaskExecutor("test-errands", Scheduler.system());
  private final Worker worker =
      (Worker)
          Proxy.newProxyInstance(
              Worker.class.getClassLoader(),
              new Class<?>[] {Worker.class},
              (proxy, method, args) -> call(method.getName(), args));
  private GoalDelegation<Wish, Worker> delegation;

  private volatile @Nullable UUID goal;
  private volatile Phase phase = Phase.IDLE;
  private volatile @Nullable Instant heldSince;
  private volatile boolean losesAnswers;
  private volatile boolean isCutOff;

  /** Somebody else has it pursue this right after it was asked how far it is. */
  private volatile @Nullable UUID othersNext;

  private @Nullable Object call(String method, Object @Nullable [] args) throws RemoteException {
    if (method.equals("toString")) {
      return "the worker";
    } else if (method.equals("hashCode")) {
      return 1;
    }
    if (isCutOff) {
      throw new RemoteException("it is out of reach");
    }
    @Nullable Object answer =
        switch (method) {
          case "pursueUnattended" -> {
            phase = Phase.RUNNING;
            heldSince = null;
            goal = UUID.randomUUID();
            yield goal;
          }
          case "cancel", "cancelUnattended" -> {
            if (args == null || args[0].equals(goal)) {
              phase = Phase.CANCELLED;
            }
            yield null;
          }
          case "status" -> {
            BehaviorStatus now =
                new BehaviorStatus(Instant.EPOCH, goal, phase, "it works", 0, 0, heldSince, 0, 0);
            @Nullable UUID next = othersNext;
            if (next != null) {
              goal = next;
            }
            yield now;
          }
          default -> throw new AssertionError(method);
        };
    if (losesAnswers && method.equals("pursueUnattended")) {
      throw new RemoteException("its answer was lost");
    }
    return answer;
  }

  @BeforeEach
  void begin() {
    directory.put(
        UUID.randomUUID(),
        worker,
        List.of(
            new ModuleAttributes(
                "atrv1",
                "worker",
                "it works",
                "localhost",
                "DFRA",
                "1",
                Readiness.READY,
                Instant.EPOCH,
                Instant.EPOCH,
                0)),
        Locality.SAME_VM);
    ModuleContext context =
        new ModuleContext(
                "atrv1", "master", Parameters.of("atrv1/master", Map.of()), InstantSource.system())
            .withDirectory(directory);
    delegation =
        new GoalDelegation<>(
            "atrv1/master",
            ModuleDependency.of(context, Worker.class, "worker"),
            taskExecutor,
            LoggerFactory.getLogger("test"));
  }

  @AfterEach
  void end() {
    taskExecutor.close();
    directory.close();
  }

  @Test
  void reportsTheStatusOfTheDelegateAndCancelsIt() throws Exception {
    assertThat(delegation.status()).isEmpty();
    delegation.start(new Wish());
    assertThat(delegation.status()).map(BehaviorStatus::goal).contains(goal);
    delegation.cancel();
    assertThat(phase).isEqualTo(Phase.CANCELLED);
    assertThat(delegation.status()).isEmpty();
  }

  @Test
  void whatAnEarlierProcessHasBegunIsTakenOver() throws Exception {
    delegation.start(new Wish());
    UUID begun = delegation.goal().orElseThrow();
    delegation.forget(); // as a process does that dies
    assertThat(delegation.status()).isEmpty();
    assertThat(delegation.adopt(UUID.randomUUID())).as("it pursues another goal").isFalse();
    delegation.cancel();
    assertThat(phase).isEqualTo(Phase.RUNNING);
    assertThat(delegation.adopt(begun)).isTrue();
    assertThat(delegation.status()).map(BehaviorStatus::goal).contains(begun);
    delegation.cancel();
    assertThat(phase).isEqualTo(Phase.CANCELLED);
    assertThat(delegation.adopt(begun)).as("it does not pursue it any more").isFalse();
    isCutOff = true;
    assertThatThrownBy(() -> delegation.adopt(begun)).isInstanceOf(RemoteException.class);
  }

  @Test
  void leavesAloneWhatSomebodyElseHasAskedForSince() throws Exception {
    delegation.start(new Wish());
    goal = UUID.randomUUID();
    assertThat(delegation.status()).isEmpty();
    delegation.cancel();
    assertThat(phase).isEqualTo(Phase.RUNNING);
  }

  @Test
  void cancelsNothingThatSomebodyElseAsksForAfterItHasLooked() throws Exception {
    delegation.start(new Wish());
    othersNext = UUID.randomUUID();
    delegation.cancel();
    assertThat(goal).isEqualTo(othersNext);
    assertThat(phase).as("the newer goal goes on").isEqualTo(Phase.RUNNING);
  }

  @Test
  void whatAnEarlierProcessHasBegunIsGivenUpByItsNameAsSoonAsTheOtherAnswers() throws Exception {
    delegation.start(new Wish());
    UUID begun = delegation.goal().orElseThrow();
    delegation.forget(); // as a process does that dies
    isCutOff = true;
    delegation.abandon(begun);
    delegation.abandon(UUID.randomUUID());
    assertThat(phase).isEqualTo(Phase.RUNNING);
    isCutOff = false;
    await().atMost(PATIENCE).until(() -> phase == Phase.CANCELLED);
    assertThat(delegation.adopt(begun)).isFalse();
    assertThat(delegation.adoptWithOutcome(begun)).isTrue();
    assertThat(delegation.status()).map(BehaviorStatus::phase).contains(Phase.CANCELLED);
  }

  @Test
  void aGoalWhoseAnswerWasLostDoesNotRunOn() {
    losesAnswers = true;
    assertThatThrownBy(() -> delegation.start(new Wish())).isInstanceOf(RemoteException.class);
    assertThat(phase).isEqualTo(Phase.RUNNING);
    delegation.cancel(); // as a behaviour does that is suspended
    assertThat(phase).isEqualTo(Phase.CANCELLED);
  }

  @Test
  void aGoalThatWasRunningBeforeIsNotTakenForOneWhoseAnswerWasLost() throws Exception {
    goal = UUID.randomUUID();
    phase = Phase.RUNNING;
    UUID others = goal;
    Worker refuses = worker;
    losesAnswers = true;
    isCutOff = true;
    assertThatThrownBy(() -> delegation.start(new Wish())).isInstanceOf(RemoteException.class);
    isCutOff = false;
    delegation.cancel();
    assertThat(refuses.status().goal()).isEqualTo(others);
    assertThat(phase).isEqualTo(Phase.RUNNING);
  }

  @Test
  void aCancellationThatFailsIsRepeatedUntilItIsAnswered() throws Exception {
    delegation.start(new Wish());
    isCutOff = true;
    delegation.cancel();
    assertThat(phase).isEqualTo(Phase.RUNNING);
    isCutOff = false;
    await().atMost(PATIENCE).until(() -> phase == Phase.CANCELLED);
  }

  @Test
  void whatSomebodyStoppedWhileItDidNotAnswerIsNotRestartedByItself() throws Exception {
    delegation.start(new Wish());
    isCutOff = true;
    delegation.cancel(); // as a behaviour does that is suspended
    stopped();
    isCutOff = false;
    assertThatThrownBy(() -> delegation.start(new Wish()))
        .isInstanceOf(DelegateHeldException.class)
        .hasMessageContaining("was stopped while it did not answer");
    assertThat(phase).isEqualTo(Phase.CANCELLED);
    delegation.start(new Wish()); // a person resumes the behaviour
    assertThat(phase).isEqualTo(Phase.RUNNING);
  }

  @Test
  void whatSomebodyStoppedWhoseAnswerWasLostIsNotRestartedByItself() {
    losesAnswers = true;
    assertThatThrownBy(() -> delegation.start(new Wish())).isInstanceOf(RemoteException.class);
    stopped();
    losesAnswers = false;
    assertThatThrownBy(() -> delegation.start(new Wish()))
        .isInstanceOf(DelegateHeldException.class);
  }

  @Test
  void aGoalThatTheDelegateLostIsNotRestartedByItself() throws Exception {
    delegation.start(new Wish());
    isCutOff = true;
    delegation.cancel();
    goal = null;
    phase = Phase.IDLE;
    isCutOff = false;
    assertThatThrownBy(() -> delegation.start(new Wish()))
        .isInstanceOf(DelegateHeldException.class)
        .hasMessageContaining("lost its goal");
  }

  private void stopped() {
    phase = Phase.CANCELLED;
    heldSince = Instant.now();
  }

  @Test
  void saysHowWhatItBeganWasLost() throws Exception {
    delegation.start(new Wish());
    assertThat(delegation.loss()).isEqualTo(GoalDelegation.GoalLoss.NONE);
    phase = Phase.IDLE; // as its next process says
    assertThat(delegation.status()).isEmpty();
    assertThat(delegation.loss()).isEqualTo(GoalDelegation.GoalLoss.DIED);
    delegation.start(new Wish());
    goal = UUID.randomUUID();
    assertThat(delegation.status()).isEmpty();
    assertThat(delegation.loss()).isEqualTo(GoalDelegation.GoalLoss.REPLACED);
    delegation.start(new Wish());
    goal = null;
    assertThat(delegation.status()).isEmpty();
    assertThat(delegation.loss()).isEqualTo(GoalDelegation.GoalLoss.FORGOTTEN);
  }
}
