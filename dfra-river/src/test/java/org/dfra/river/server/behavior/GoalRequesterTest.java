package org.dfra.river.server.behavior;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.awaitility.Awaitility.await;

import java.lang.reflect.Proxy;
import java.math.BigInteger;
import java.rmi.RemoteException;
import java.time.Duration;
import java.time.InstantSource;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.CopyOnWriteArrayList;
import net.jini.export.ServerContext;
import org.dfra.behavior.BehaviorStatus.Phase;
import org.dfra.behavior.Goal;
import org.dfra.behavior.GoalRefusedException;
import org.dfra.core.behavior.BehaviorImpl;
import org.dfra.core.behavior.GoalExecution;
import org.dfra.core.behavior.GoalProgress;
import org.dfra.core.config.Parameters;
import org.dfra.core.module.ModuleContext;
import org.dfra.core.state.StateStore;
import org.dfra.river.identity.ChannelIdentity;
import org.dfra.river.identity.ChannelPeer;
import org.dfra.river.identity.CurrentIdentity;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** A goal whose giver is revoked is paused. */
@Timeout(60)
class GoalRequesterTest {

  private static final Duration PATIENCE = Duration.ofSeconds(20);
  private static final long ANNA = 7;
  private static final long OSCAR = 9;
  private static final long OWN = 0; // without a number
  private static final long NOBODY = 99;

  /** On whose behalf the next call is. */
  private long delegating = NOBODY;

  private final Set<BigInteger> revoked = ConcurrentHashMap.newKeySet();
  private final List<Runnable> listeners = new CopyOnWriteArrayList<>();
  private final StateStore state = StateStore.inMemory();
  private final Walk walk = new Walk(state, false);
  private GoalRequester requester = watching(walk);

  private record Distance(double metres) implements Goal {}

  /** A behaviour that goes on until it is stopped. */
  private static final class Walk extends BehaviorImpl<Distance> {

    private final boolean isRestored;

    Walk(StateStore state, boolean isRestored) {
      super(
          new ModuleContext(
              "atrv1",
              "walk",
              Parameters.of("atrv1/walk", Map.of("rate", "50")),
              InstantSource.system(),
              state),
          "walks",
          "DFRA",
          "1",
          Distance.class,
          10);
      this.isRestored = isRestored;
      start();
    }

    @Override
    protected void onStart() {
      super.onStart();
      if (isRestored) {
        restoreGoal(startGoal(new Distance(1)), Phase.RUNNING, GoalProgress.inProgress("", 0));
      }
    }

    @Override
    protected GoalExecution startGoal(Distance goal) {
      if (goal.metres() <= 0) {
        throw new GoalRefusedException("it is there already");
      }
      return new GoalExecution() {
        @Override
        public GoalProgress step() {
          return GoalProgress.inProgress("it walks", 0);
        }

        @Override
        public void suspend() {}
      };
    }
  }

  private GoalRequester watching(Walk behavior) {
    ChannelIdentity identity =
        (ChannelIdentity)
            Proxy.newProxyInstance(
                getClass().getClassLoader(),
                new Class<?>[] {ChannelIdentity.class},
                (self, method, arguments) ->
                    switch (method.getName()) {
                      case "isRevoked" -> revoked.contains((BigInteger) arguments[0]);
                      case "addRevocationListener" -> listeners.add((Runnable) arguments[0]);
                      case "removeRevocationListener" -> listeners.remove(arguments[0]);
                      default -> throw new UnsupportedOperationException(method.toString());
                    });
    return CurrentIdentity.callAs(identity, () -> new GoalRequester("atrv1/walk", behavior));
  }

  @AfterEach
  void close() {
    requester.close();
    walk.close();
    assertThat(listeners).isEmpty();
  }

  private void by(long number, GoalRequester.Request<?> request) {
    ChannelPeer peer =
        (ChannelPeer)
            Proxy.newProxyInstance(
                getClass().getClassLoader(),
                new Class<?>[] {ChannelPeer.class},
                (self, method, arguments) ->
                    switch (method.getName()) {
                      case "certificateNumbers" ->
                          number == OWN
                              ? List.of()
                              : List.of(BigInteger.valueOf(number), BigInteger.valueOf(delegating));
                      default -> throw new UnsupportedOperationException(method.toString());
                    });
    ServerContext.doWithServerContext(
        () -> {
          try {
            Object unused = requester.by(request);
          } catch (RemoteException e) {
            throw new IllegalStateException(e);
          }
        },
        List.of(peer));
  }

  private void pursue(long number) {
    by(number, () -> Objects.requireNonNull(walk.pursue(new Distance(5))));
  }

  private void revoke(long number) {
    revoked.add(BigInteger.valueOf(number));
    listeners.forEach(Runnable::run);
  }

  private void awaitPaused(Walk behavior) {
    await().atMost(PATIENCE).until(() -> behavior.status().phase() == Phase.PAUSED);
    assertThat(behavior.status().activity()).contains("revoked");
    assertThat(behavior.status().heldSince()).as("no program may resume it").isNotNull();
  }

  @Test
  void pausesTheGoalOfARevokedMemberOnly() {
    pursue(ANNA);
    revoke(OSCAR);
    assertThat(walk.status().phase()).isEqualTo(Phase.RUNNING);
    revoke(ANNA);
    awaitPaused(walk);
    walk.resumeUnattended();
    assertThat(walk.status().phase()).isEqualTo(Phase.PAUSED);
  }

  @Test
  void pausesAGoalThatWasGivenOnBehalfOfARevokedMember() {
    delegating = OSCAR;
    pursue(ANNA);
    delegating = NOBODY;
    revoke(NOBODY);
    assertThat(walk.status().phase()).isEqualTo(Phase.RUNNING);
    revoke(OSCAR);
    awaitPaused(walk);
  }

  @Test
  void theOneWhoResumesAGoalIsResponsibleForIt() {
    pursue(ANNA);
    walk.pause();
    by(
        OSCAR,
        () -> {
          walk.resume();
          return true;
        });
    revoke(ANNA);
    assertThat(walk.status().phase()).isEqualTo(Phase.RUNNING);
    revoke(OSCAR);
    awaitPaused(walk);
  }

  @Test
  void theRobotsOwnGoalsGoOn() {
    pursue(ANNA);
    walk.cancel();
    pursue(OWN);
    revoke(ANNA);
    assertThat(walk.requester()).isEmpty();
    assertThat(walk.status().phase()).isEqualTo(Phase.RUNNING);
  }

  @Test
  void aRefusedGoalChangesNothing() {
    pursue(ANNA);
    assertThatThrownBy(() -> by(OSCAR, () -> walk.pursue(new Distance(0))))
        .isInstanceOf(GoalRefusedException.class);
    revoke(OSCAR);
    assertThat(walk.status().phase()).isEqualTo(Phase.RUNNING);
    revoke(ANNA);
    awaitPaused(walk);
  }

  @Test
  void whoIsRevokedDuringTheCallHasBegunNothing() {
    by(
        ANNA,
        () -> {
          revoke(ANNA); // after the guard has permitted the call
          return walk.pursue(new Distance(5));
        });
    awaitPaused(walk);
  }

  @Test
  void aGoalThatOutlivesItsProcessIsPausedTooIfItsGiverWasRevokedMeanwhile() {
    pursue(ANNA);
    requester.close();
    walk.close();
    revoked.add(BigInteger.valueOf(ANNA));
    Walk restored = new Walk(state, true);
    assertThat(restored.status().phase()).isEqualTo(Phase.RUNNING);
    requester = watching(restored);
    awaitPaused(restored);
    requester.close();
    restored.close();
  }
}
