package org.dfra.core.policy;

import static org.assertj.core.api.Assertions.assertThat;
import static org.dfra.core.policy.PolicyFixture.ANNA;
import static org.dfra.core.policy.PolicyFixture.ATRV1;
import static org.dfra.core.policy.PolicyFixture.BOB;
import static org.dfra.core.policy.PolicyFixture.call;
import static org.dfra.core.policy.PolicyFixture.policy;

import java.time.Instant;
import java.time.InstantSource;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.concurrent.atomic.AtomicLong;
import org.dfra.core.policy.ConfirmationRequests.PendingConfirmation;
import org.dfra.security.AccessRequest;
import org.dfra.security.Behalf;
import org.dfra.security.Caller;
import org.dfra.security.Caller.Standing;
import org.dfra.security.Decision;
import org.dfra.security.Member;
import org.dfra.security.MemberRole;
import org.junit.jupiter.api.Test;

/** Calls that a member makes on another one's behalf. */
class DelegatedDecisionsTest {

  private static final String STOPPED = "emergencyStop";
  private static final Caller FOR_ANNA = ATRV1.onBehalfOf(of(ANNA));
  private static final Caller UNPROVED = ATRV1.onBehalfOf(Behalf.unproved("it has expired"));

  private static Behalf of(Caller principal) {
    return Behalf.of(principal.member().orElseThrow());
  }

  private static Decision decide(Policy policy, Caller caller, String method) {
    return new PolicyGuard(policy).decide(call(caller, method));
  }

  private static final Policy STANDARD = BuiltInPolicies.standard("field");

  @Test
  void underTheStandardPolicyARobotCommandsForAnOperatorAndNothingMore() {
    assertThat(decide(STANDARD, ATRV1, "execute").isPermitted()).isFalse();
    Decision commanded = decide(STANDARD, FOR_ANNA, "execute");
    assertThat(commanded.isPermitted()).isTrue();
    assertThat(commanded.rule()).isEqualTo("delegates, operators");
    for (String each : List.of("releaseEmergencyStop", "setParameter", "readiness", "subscribe")) {
      assertThat(decide(STANDARD, FOR_ANNA, each).isPermitted()).as(each).isFalse();
    }
    Caller forBob = ATRV1.onBehalfOf(of(BOB));
    assertThat(decide(STANDARD, forBob, "execute").isPermitted()).isFalse();
    Caller expired =
        new Caller(Standing.EXPIRED, ATRV1.member(), ATRV1.address(), Optional.of(of(ANNA)));
    assertThat(decide(STANDARD, expired, "execute").isPermitted()).isFalse();
  }

  @Test
  void aStopIsNeverRefusedForWhatItCarries() {
    for (Caller each : List.of(ATRV1, FOR_ANNA, UNPROVED)) {
      Decision stop = decide(STANDARD, each, STOPPED);
      assertThat(stop.isPermitted()).as(each.toString()).isTrue();
      assertThat(stop.rule()).isEqualTo("stop");
    }
  }

  @Test
  void whatProvesNothingIsRefusedWithItsReason() {
    Decision refused = decide(policy("<permit/>"), UNPROVED, "execute");
    assertThat(refused.isPermitted()).isFalse();
    assertThat(refused.rule()).isEqualTo("delegation");
    assertThat(refused.reason()).isEqualTo("it has expired");
  }

  @Test
  void bothMustBePermitted() {
    Policy onlyPrincipal = policy("<permit role=\"operator\"/>", "<permit role=\"robot\"/>");
    Decision refused = decide(onlyPrincipal, FOR_ANNA, "execute");
    assertThat(refused.isPermitted()).as("the robot's own right is not for others").isFalse();
    assertThat(refused.reason()).contains("robot atrv1 of field for operator anna of field");
    Policy onlyBearer = policy("<permit role=\"robot\" for-member=\"anna\"/>");
    assertThat(decide(onlyBearer, FOR_ANNA, "execute").isPermitted()).isFalse();
    Policy both =
        policy("<permit role=\"robot\" for-member=\"anna\"/>", "<permit role=\"operator\"/>");
    assertThat(decide(both, FOR_ANNA, "execute").isPermitted()).isTrue();
    assertThat(decide(both, ATRV1, "execute").isPermitted()).isFalse();
  }

  @Test
  void aDenialIsAboutCallsForOthersTooUnlessItNamesThem() {
    String permits = "<permit role=\"robot\" for-role=\"operator\"/><permit role=\"operator\"/>";
    assertThat(
            decide(policy("<deny member=\"atrv1\"/>" + permits), FOR_ANNA, "execute").isPermitted())
        .isFalse();
    Policy notForOthers = policy("<deny for-role=\"operator\"/><permit/>" + permits);
    assertThat(decide(notForOthers, FOR_ANNA, "execute").isPermitted()).isFalse();
    assertThat(decide(notForOthers, ATRV1, "execute").isPermitted()).isTrue();
    Policy notForBert = policy("<deny for-member=\"bert\"/>" + permits);
    assertThat(decide(notForBert, FOR_ANNA, "execute").isPermitted()).isTrue();
  }

  @Test
  void aRateIsCountedForBoth() {
    Policy limited =
        policy(
            "<permit role=\"robot\" for-role=\"operator\"/>",
            "<permit role=\"operator\"><rate max=\"2\" per=\"1h\"/></permit>");
    PolicyGuard guard = new PolicyGuard(limited);
    AccessRequest forAnna = call(FOR_ANNA, "execute");
    assertThat(guard.decide(forAnna).isPermitted()).isTrue();
    assertThat(guard.decide(call(ANNA, "execute")).isPermitted()).isTrue();
    assertThat(guard.decide(forAnna).isPermitted()).as("anna's third call").isFalse();
    Caller forBert = ATRV1.onBehalfOf(Behalf.of(new Member("field", MemberRole.OPERATOR, "bert")));
    assertThat(guard.decide(call(forBert, "execute")).isPermitted()).isTrue();
  }

  private final AtomicLong nanos = new AtomicLong();
  private final ConfirmationRequests requests =
      new ConfirmationRequests(nanos::get, new Random(2026), () -> {});
  private final List<DecisionRecord> observed = new ArrayList<>();

  private PolicyGuard asking(String... lines) {
    return new PolicyGuard(
        policy(lines),
        PolicyFacts.none(),
        requests,
        observed::add,
        InstantSource.fixed(Instant.EPOCH),
        nanos::get);
  }

  private void confirmAll() {
    for (PendingConfirmation each : requests.pending()) {
      assertThat(requests.answer(each.id(), true)).isTrue();
    }
  }

  @Test
  void aConfirmationIsForOneCallerAndOnePrincipal() {
    Caller forBert = ATRV1.onBehalfOf(Behalf.of(new Member("field", MemberRole.OPERATOR, "bert")));
    PolicyGuard guard =
        asking(
            "<permit role=\"robot\" for-role=\"operator\"><ask/></permit>",
            "<permit role=\"operator\"/>");
    assertThat(guard.decide(call(FOR_ANNA, "execute")).isPermitted()).isFalse();
    confirmAll();
    assertThat(guard.decide(call(forBert, "execute")).isPermitted())
        .as("what was confirmed for anna")
        .isFalse();
    assertThat(guard.decide(call(FOR_ANNA, "execute")).isPermitted()).isTrue();
  }

  @Test
  void whatAnOperatorsOwnCallWasConfirmedForIsNoneOfTheOneWhoActsForHer() {
    PolicyGuard guard =
        asking(
            "<permit role=\"robot\" for-role=\"operator\"/>",
            "<permit role=\"operator\"><ask/></permit>");
    assertThat(guard.decide(call(ANNA, "execute")).isPermitted()).isFalse();
    confirmAll();
    assertThat(guard.decide(call(FOR_ANNA, "execute")).isPermitted())
        .as("anna's own confirmation")
        .isFalse();
    assertThat(requests.pending())
        .as("who sees the request knows who makes the call")
        .singleElement()
        .satisfies(each -> assertThat(each.request().caller()).isEqualTo(FOR_ANNA));
    assertThat(guard.decide(call(ANNA, "execute")).isPermitted()).isTrue();
    confirmAll();
    assertThat(guard.decide(call(ANNA, "execute")).isPermitted()).isFalse();
    assertThat(guard.decide(call(FOR_ANNA, "execute")).isPermitted()).isTrue();
  }

  @Test
  void confirmationsOfBothRulesAreAskedForAtOnceAndUsedTogether() {
    PolicyGuard guard =
        asking(
            "<permit name=\"a\" role=\"robot\" for-role=\"operator\"><ask/></permit>",
            "<permit name=\"b\" role=\"operator\"><ask/></permit>");
    assertThat(guard.decide(call(FOR_ANNA, "execute")).isPermitted()).isFalse();
    assertThat(requests.pending()).hasSize(2);
    assertThat(requests.answer(requests.pending().get(0).id(), true)).isTrue();
    assertThat(guard.decide(call(FOR_ANNA, "execute")).isPermitted()).as("one of two").isFalse();
    confirmAll();
    assertThat(guard.decide(call(FOR_ANNA, "execute")).isPermitted()).isTrue();
    assertThat(guard.decide(call(FOR_ANNA, "execute")).isPermitted()).isFalse();
  }

  @Test
  void theLogHasOneDecisionWithBothMembers() {
    PolicyGuard guard =
        asking(
            "<permit name=\"a\" role=\"robot\" for-role=\"operator\"><log/></permit>",
            "<deny name=\"b\" role=\"operator\"><notify/></deny>");
    assertThat(guard.decide(call(FOR_ANNA, "execute")).isPermitted()).isFalse();
    assertThat(observed).hasSize(1);
    assertThat(DecisionLog.sentence(observed.get(0)))
        .startsWith("Refused Effector.execute on drive to " + FOR_ANNA + " by rule b of");
    assertThat(observed.get(0).obligations().isLogged()).isTrue();
    assertThat(observed.get(0).obligations().isNotified()).isTrue();
  }
}
