package org.dfra.river.server.behavior;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.awaitility.Awaitility.await;

import java.lang.reflect.Proxy;
import java.math.BigInteger;
import java.nio.charset.StandardCharsets;
import java.rmi.RemoteException;
import java.time.Duration;
import java.time.InstantSource;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.stream.Stream;
import net.jini.export.ServerContext;
import org.dfra.behavior.Behavior;
import org.dfra.behavior.BehaviorStatus.Phase;
import org.dfra.behavior.Goal;
import org.dfra.behavior.GoalRefusedException;
import org.dfra.core.behavior.BehaviorImpl;
import org.dfra.core.behavior.GoalExecution;
import org.dfra.core.behavior.GoalProgress;
import org.dfra.core.config.Parameters;
import org.dfra.core.module.ModuleContext;
import org.dfra.core.policy.Policy;
import org.dfra.core.policy.PolicyGuard;
import org.dfra.core.policy.PolicyXml;
import org.dfra.core.policy.method.InterfaceCatalogue;
import org.dfra.core.state.StateStore;
import org.dfra.river.identity.ChannelIdentity;
import org.dfra.river.identity.ChannelPeer;
import org.dfra.river.identity.CurrentIdentity;
import org.dfra.security.AccessRequest;
import org.dfra.security.Behalf;
import org.dfra.security.Caller;
import org.dfra.security.Member;
import org.dfra.security.MemberRole;
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

  /** The next call, if a guard decides about it. */
  private Optional<AccessRequest> permitted = Optional.empty();

  private final PolicyGuard guard = new PolicyGuard(policy(7, "<permit/>"));

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
                      case "guard" -> guard;
                      case "robot" -> "atrv1";
                      default -> throw new UnsupportedOperationException(method.toString());
                    });
    return CurrentIdentity.callAs(
        identity, () -> new GoalRequester("atrv1/walk", behavior, GoToWaypointServer.class));
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
        Stream.concat(Stream.of(peer), permitted.stream()).toList());
  }

  private static Policy policy(long version, String rules) {
    String text =
        "<policy xmlns=\"urn:dfra:policy:1\" team=\"field\" version=\"%d\">%s</policy>"
            .formatted(version, rules);
    return PolicyXml.read(
        text.getBytes(StandardCharsets.UTF_8), "policy.xml", InterfaceCatalogue.builtIn());
  }

  private static Member member(MemberRole role, String name) {
    return new Member("field", role, name);
  }

  /** Lets the guard know the calls that follow. */
  private void guarded(String caller, String method, Optional<Member> principal) throws Exception {
    Caller alone =
        new Caller(
            Caller.Standing.MEMBER, Optional.of(member(MemberRole.OPERATOR, caller)), "192.0.2.7");
    permitted =
        Optional.of(
            new AccessRequest(
                principal.map(each -> alone.onBehalfOf(Behalf.of(each))).orElse(alone),
                "atrv1",
                "walk",
                GoToWaypointServer.class,
                Stream.of(Behavior.class.getMethods())
                    .filter(each -> each.getName().equals(method))
                    .findFirst()
                    .orElseThrow()));
    assertThat(guard.decide(permitted.get()).isPermitted()).isTrue();
  }

  private void replace(String rules) {
    assertThat(guard.replace(policy(guard.policy().version() + 1, rules))).isTrue();
  }

  private void awaitPausedByPolicy(Walk behavior, String why) {
    await().atMost(PATIENCE).until(() -> behavior.status().phase() == Phase.PAUSED);
    assertThat(behavior.status().activity()).contains(why);
    assertThat(behavior.status().heldSince()).as("no program may resume it").isNotNull();
  }

  private void awaitReviewed() {
    await()
        .atMost(PATIENCE)
        .until(() -> walk.requester().contains("policy=" + guard.policy().version()));
  }

  @Test
  void pausesAGoalWhoseGiverANewPolicyDoesNotPermit() throws Exception {
    guarded("anna", "pursue", Optional.empty());
    pursue(ANNA);
    replace("<deny member=\"oscar\"/><permit/>");
    awaitReviewed();
    assertThat(walk.status().phase()).isEqualTo(Phase.RUNNING);
    replace("<deny member=\"anna\" interface=\"GoToWaypoint\" method=\"resume\"/><permit/>");
    awaitReviewed();
    assertThat(walk.status().phase()).as("she did not resume it").isEqualTo(Phase.RUNNING);
    replace("<deny member=\"anna\" interface=\"GoToWaypoint\" kind=\"command\"/><permit/>");
    awaitPausedByPolicy(walk, "policy 10 does not permit operator anna of field what started it");
    replace("<permit/>");
    awaitReviewed();
    assertThat(walk.status().phase()).as("a policy moves nothing").isEqualTo(Phase.PAUSED);
  }

  @Test
  void pausesAGoalOnBehalfOfSomebodyWhomANewPolicyDoesNotPermit() throws Exception {
    replace("<permit for-role=\"operator\"/><permit/>");
    guarded("anna", "resume", Optional.of(member(MemberRole.OPERATOR, "oscar")));
    pursue(ANNA);
    replace("<deny member=\"oscar\" method=\"resume\"/><permit for-role=\"operator\"/><permit/>");
    awaitPausedByPolicy(walk, "operator anna of field for operator oscar of field");
  }

  @Test
  void theRobotsOwnProgramsResumeAGoalForTheOneWhoGaveIt() throws Exception {
    guarded("anna", "pursue", Optional.empty());
    pursue(ANNA);
    walk.pauseUnattended();
    Caller own =
        new Caller(
            Caller.Standing.OWN, Optional.of(member(MemberRole.ROBOT, "atrv1")), "127.0.0.1");
    AccessRequest resuming = permitted.orElseThrow().by(own);
    ServerContext.doWithServerContext(
        () -> {
          try {
            boolean unused =
                requester.byProgram(
                    () -> {
                      walk.resumeUnattended();
                      return true;
                    });
          } catch (RemoteException e) {
            throw new IllegalStateException(e);
          }
        },
        List.of(resuming));
    assertThat(walk.status().phase()).isEqualTo(Phase.RUNNING);
    revoke(OSCAR);
    assertThat(walk.status().phase()).isEqualTo(Phase.RUNNING);
    revoke(ANNA);
    awaitPaused(walk);
  }

  @Test
  void aPolicyThatReplacesTheOneOfTheCallMeanwhileCounts() throws Exception {
    guarded("anna", "pursue", Optional.empty());
    by(
        ANNA,
        () -> {
          replace("<permit member=\"oscar\"/>"); // after the guard has permitted the call
          return walk.pursue(new Distance(5));
        });
    awaitPausedByPolicy(walk, "operator anna of field");
  }

  @Test
  void aProcessThatIsRestartedDecidesAgainByAnotherPolicyOnly() throws Exception {
    guarded("anna", "pursue", Optional.empty());
    replace("<permit><while fact=\"load\" is=\"none\"/></permit>"); // which nobody knows now
    String stored = GoalGiver.of(List.of(), permitted, 8).text();
    walk.storeRequester(stored);
    assertThat(walk.pursue(new Distance(5))).isNotNull();
    requester.close();
    walk.close();
    Walk restored = new Walk(state, true);
    requester = watching(restored);
    assertThat(restored.status().phase()).as("by the same policy").isEqualTo(Phase.RUNNING);
    assertThat(restored.requester()).isEqualTo(stored);
    requester.close();
    restored.close();
    assertThat(guard.replace(policy(9, "<permit member=\"oscar\"/>"))).isTrue();
    Walk next = new Walk(state, true);
    requester = watching(next);
    awaitPausedByPolicy(next, "policy 9 does not permit operator anna of field");
    requester.close();
    next.close();
  }

  @Test
  void whatWasStoredIsReadAgainAndWhatCannotBeReadIsNobody() {
    Caller robot =
        new Caller(
                Caller.Standing.OWN,
                Optional.of(member(MemberRole.ROBOT, "atrv1")),
                "an earlier call")
            .onBehalfOf(Behalf.of(member(MemberRole.OPERATOR, "an.na-1_x")));
    GoalGiver giver =
        new GoalGiver(
            List.of(BigInteger.valueOf(ANNA), BigInteger.TEN),
            new GoalGiver.GoalCall(robot, "pursue", 12));
    assertThat(GoalGiver.parse(giver.text())).isEqualTo(giver);
    assertThat(GoalGiver.parse("7 a"))
        .as("of an earlier version")
        .isEqualTo(new GoalGiver(giver.certificates(), null));
    assertThat(GoalGiver.parse("")).isEqualTo(new GoalGiver(List.of(), null));
    for (String bad :
        List.of("x", ";policy=1", "7;", "7;policy=1;method=pursue;standing=MEMBER;member=anna")) {
      assertThatThrownBy(() -> GoalGiver.parse(bad))
          .as(bad)
          .isInstanceOf(IllegalArgumentException.class);
    }
    walk.storeRequester("x");
    revoke(ANNA);
    assertThat(walk.status().phase()).isEqualTo(Phase.IDLE);
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
