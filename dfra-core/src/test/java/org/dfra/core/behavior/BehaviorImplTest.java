package org.dfra.core.behavior;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.awaitility.Awaitility.await;

import java.rmi.RemoteException;
import java.time.Duration;
import java.time.InstantSource;
import java.util.List;
import java.util.Map;
import java.util.UUID;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.CyclicBarrier;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import org.dfra.behavior.BehaviorStatus;
import org.dfra.behavior.BehaviorStatus.Phase;
import org.dfra.behavior.Goal;
import org.dfra.behavior.GoalRefusedException;
import org.dfra.core.config.Parameters;
import org.dfra.core.directory.InMemoryModuleDirectory;
import org.dfra.core.module.ModuleContext;
import org.dfra.event.DeliveryPolicy;
import org.dfra.event.ModuleEvent;
import org.dfra.event.Subscription;
import org.dfra.flow.effector.BrakeEngagedException;
import org.dfra.flow.effector.StoppedCommandException;
import org.dfra.module.NotReadyException;
import org.dfra.module.Readiness;
import org.dfra.persona.BehaviorAttributes;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

@Timeout(60)
class BehaviorImplTest {

  private static final Duration PATIENCE = Duration.ofSeconds(20);

  /** Something to wish for; null cannot be reached. */
  private record Wish(String what) implements Goal {}

  private final AtomicInteger rests = new AtomicInteger();
  private final AtomicInteger steps = new AtomicInteger();
  private final InMemoryModuleDirectory directory = new InMemoryModuleDirectory();
  private final Genie genie = new Genie("genie");

  /** What the next turns come to; the last goes for all that follow. */
  private final LinkedBlockingQueue<Object> turns = genie.script;

  private final List<BehaviorStatus> told = new CopyOnWriteArrayList<>();

  private final class Genie extends BehaviorImpl<Wish> {

    private Object last = Progress.going("it rubs the lamp", 0);

    private final LinkedBlockingQueue<Object> script = new LinkedBlockingQueue<>();

    Genie(String name) {
      super(
          new ModuleContext(
                  "atrv1",
                  name,
                  Parameters.of("atrv1/" + name, Map.of("rate", "50")),
                  InstantSource.system())
              .among(directory),
          "grants wishes",
          "DFRA",
          "1",
          Wish.class,
          10);
    }

    @Override
    protected Pursuit begin(Wish goal) {
      if (goal.what().isEmpty()) {
        throw new GoalRefusedException("a wish for nothing; wish for something");
      }
      return new Pursuit() {
        @Override
        public Progress step() throws RemoteException {
          steps.incrementAndGet();
          @Nullable Object next = script.poll();
          if (next instanceof Runnable waiting) {
            waiting.run();
            next = null;
          }
          last = next == null ? last : next;
          if (last instanceof RemoteException e) {
            throw e;
          } else if (last instanceof RuntimeException e) {
            throw e;
          } else if (last instanceof Error e) {
            throw e;
          }
          return (Progress) last;
        }

        @Override
        public void rest() {
          rests.incrementAndGet();
        }
      };
    }
  }

  @BeforeEach
  void start() {
    genie.start();
    Subscription unused =
        genie.subscribe(
            delivery -> {
              if (delivery.event() instanceof ModuleEvent.NewReading fresh) {
                told.add((BehaviorStatus) fresh.reading());
              }
            },
            DeliveryPolicy.keepLast(1000));
  }

  @AfterEach
  void end() {
    genie.close();
    directory.close();
  }

  private static void awaitPhase(Genie genie, Phase phase) {
    await().atMost(PATIENCE).until(() -> genie.status().phase() == phase);
  }

  private void awaitTold(String doing) {
    await()
        .atMost(PATIENCE)
        .until(() -> told.stream().anyMatch(status -> status.doing().equals(doing)));
  }

  @Test
  void reachesAGoalAndTellsHowFarItIs() throws Exception {
    assertThat(genie.status().phase()).isEqualTo(Phase.IDLE);
    UUID goal = genie.pursue(new Wish("gold"));
    turns.add(Progress.going("it digs", 0.4));
    awaitTold("it digs");
    turns.add(Progress.going("it digs on", 0.3)); // never falls
    awaitTold("it digs on");
    assertThat(genie.status().done()).isEqualTo(0.4);
    turns.add(Progress.reached("here it is"));
    awaitPhase(genie, Phase.SUCCEEDED);
    awaitTold("here it is");
    assertThat(genie.status().goal()).isEqualTo(goal);
    assertThat(genie.status().done()).isEqualTo(1);
    assertThat(rests.get()).as("comes to rest").isEqualTo(1);
    assertThat(told).allMatch(status -> goal.equals(status.goal()));
  }

  @Test
  void countsThePartsOfItsGoal() throws Exception {
    UUID unused = genie.pursue(new Wish("three wishes"));
    turns.add(Progress.going("it grants", 0.4).missing(1).counting(1, 3));
    awaitTold("it grants");
    turns.add(Progress.going("it grants", 0.4).missing(1).counting(2, 3)); // same words: news
    await().atMost(PATIENCE).until(() -> told.get(told.size() - 1).partsDone() == 2);
    genie.pause();
    BehaviorStatus paused = genie.status();
    assertThat(paused.partsDone()).isEqualTo(2);
    assertThat(paused.parts()).isEqualTo(3);
    assertThat(paused.missed()).isEqualTo(1);
  }

  @Test
  void numbersThatCannotBeAreAFaultThatEndsTheGoal() throws Exception {
    UUID unused = genie.pursue(new Wish("three wishes"));
    turns.add(Progress.going("it grants", 0.4).counting(4, 3));
    awaitPhase(genie, Phase.FAILED);
    assertThat(genie.status().doing()).contains("parts done 4 is outside 0 to 3");
  }

  @Test
  void pausesKeepsTheGoalAndGoesOn() throws Exception {
    UUID goal = genie.pursue(new Wish("gold"));
    turns.add(Progress.going("it digs", 0.4));
    awaitTold("it digs");

    genie.pause();
    int paused = steps.get();
    assertThat(genie.status().phase()).isEqualTo(Phase.PAUSED);
    assertThat(rests.get()).isEqualTo(1);
    genie.pause();
    assertThat(rests.get()).as("the second time nothing is done").isEqualTo(1);
    assertThatThrownBy(() -> genie.pursue(new Wish("silver")))
        .isInstanceOf(GoalRefusedException.class)
        .hasMessage(
            "atrv1/genie is at another goal (it was told to pause); cancel that first, or wait for"
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
    turns.add(Progress.held("its brake is set", 0.5));
    awaitPhase(genie, Phase.PAUSED);
    genie.resumeUnattended();
    assertThat(genie.status().phase()).as("a brake paused it").isEqualTo(Phase.PAUSED);
    assertThat(genie.status().goal()).isEqualTo(goal);
  }

  @Test
  void waitsAtRestForWhatIsMissingAndGoesOn() throws Exception {
    UUID goal = genie.pursue(new Wish("gold"));
    turns.add(Progress.going("it digs", 0.4));
    awaitTold("it digs");
    turns.add(new NotReadyException("atrv1/laser", Readiness.INITIALIZING, "no scan has come yet"));
    awaitTold("it waits: atrv1/laser is INITIALIZING: no scan has come yet");
    assertThat(rests.get()).isGreaterThan(0);
    turns.add(new RemoteException("it is out of reach"));
    awaitTold("it waits: it is out of reach");
    turns.add(new RemoteException("the link broke", new java.io.IOException("reset")));
    awaitTold("it waits: a call failed: the link broke");
    assertThat(genie.status().phase()).isEqualTo(Phase.RUNNING);
    turns.add(Progress.reached("here it is"));
    awaitPhase(genie, Phase.SUCCEEDED);
    assertThat(genie.status().goal()).isEqualTo(goal);
  }

  @Test
  void givesUpWhereAnEffectorIsStoppedForAnEmergencyAndDoesNotGoOnWhenItIsReleased()
      throws Exception {
    UUID unused = genie.pursue(new Wish("gold"));
    turns.add(new StoppedCommandException("atrv1/drive is stopped for an emergency"));
    awaitPhase(genie, Phase.CANCELLED);
    assertThat(genie.status().doing()).isEqualTo("atrv1/drive is stopped for an emergency");
    assertThat(rests.get()).isPositive();
    turns.add(Progress.going("it digs", 0.4)); // it is released: a turn would take this
    int stepped = steps.get();
    UUID again = genie.pursue(new Wish("silver"));
    awaitTold("it digs");
    assertThat(steps.get()).as("only for who asked anew").isGreaterThan(stepped);
    assertThat(told)
        .filteredOn(each -> each.doing().equals("it digs"))
        .allMatch(each -> again.equals(each.goal()));
  }

  @Test
  void pausesWhereABrakeIsSetAndGoesOnWhenSomebodyResumesIt() throws Exception {
    UUID goal = genie.pursue(new Wish("gold"));
    turns.add(new BrakeEngagedException("atrv1/drive has its brake set"));
    awaitPhase(genie, Phase.PAUSED);
    assertThat(genie.status().doing())
        .isEqualTo("atrv1/drive has its brake set; when it may move, resume the goal");
    assertThat(rests.get()).isPositive();
    int stepped = steps.get();
    turns.add(Progress.reached("here it is")); // it is released: a cycle would take this
    genie.resume();
    awaitPhase(genie, Phase.SUCCEEDED);
    assertThat(steps.get()).as("none before it was resumed").isEqualTo(stepped + 1);
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
  void givesUpAtAFaultOfItsOwnAndCanBeAskedAgain() throws Exception {
    UUID unused = genie.pursue(new Wish("gold"));
    turns.add(new IllegalStateException("the lamp is broken"));
    awaitPhase(genie, Phase.FAILED);
    assertThat(genie.status().doing()).contains("the lamp is broken");
    assertThat(rests.get()).isEqualTo(1);
    assertThat(genie.history().recent())
        .anyMatch(incident -> incident.toString().contains("the lamp is broken"));
    turns.add(Progress.reached("here it is"));
    UUID again = genie.pursue(new Wish("gold"));
    awaitPhase(genie, Phase.SUCCEEDED);
    assertThat(genie.status().goal()).isEqualTo(again);
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
  void whoPausesOrCancelsIsObeyedThoughATurnIsHeldUp() throws Exception {
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
    assertThat(rests.get()).as("the turn is under way still").isZero();
    mayEnd.countDown();
    await().atMost(PATIENCE).until(() -> rests.get() == 1);
    assertThat(genie.status().phase())
        .as("what the turn came to is late")
        .isEqualTo(Phase.CANCELLED);
    assertThat(genie.status().goal()).isEqualTo(goal);
    assertThat(genie.pursue(new Wish("silver"))).isNotEqualTo(goal);
  }

  @Test
  void closesThoughATurnIsHeldUpAndTellsWhoAsks() throws Exception {
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

  /** The next turn waits; the answer is counted down when it does. */
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
    turns.add(GoalRefusedException.busy("atrv1/lamp is at another goal"));
    awaitTold("it waits: atrv1/lamp is at another goal");
    turns.add(new GoalRefusedException("there is no gold"));
    awaitPhase(genie, Phase.FAILED);
    assertThat(genie.status().doing()).contains("there is no gold");
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
    turns.add(Progress.held("its lamp was taken", 0.5));
    awaitPhase(genie, Phase.PAUSED);
    assertThat(genie.status().doing()).isEqualTo("its lamp was taken");
    assertThat(rests.get()).isEqualTo(1);
    turns.add(Progress.cancelled("its lamp was broken", 0.6));
    genie.resume();
    awaitPhase(genie, Phase.CANCELLED);
    assertThat(genie.status().goal()).isEqualTo(goal);
    assertThat(genie.status().done()).isEqualTo(0.6);
  }

  @Test
  void tellsItsPhaseInItsPersona() throws Exception {
    assertThat(genie.attributes()).contains(new BehaviorAttributes("Wish", false, "IDLE", 50));
    UUID unused = genie.pursue(new Wish("gold"));
    assertThat(genie.attributes()).contains(new BehaviorAttributes("Wish", false, "RUNNING", 50));
  }
}
