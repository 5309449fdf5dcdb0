package org.dfra.core.policy;

import static org.assertj.core.api.Assertions.assertThat;
import static org.dfra.core.policy.PolicyFixture.ANNA;
import static org.dfra.core.policy.PolicyFixture.ATRV1;
import static org.dfra.core.policy.PolicyFixture.BOB;
import static org.dfra.core.policy.PolicyFixture.OWN;
import static org.dfra.core.policy.PolicyFixture.STRANGER;
import static org.dfra.core.policy.PolicyFixture.call;
import static org.dfra.core.policy.PolicyFixture.member;
import static org.dfra.core.policy.PolicyFixture.policy;

import java.util.Optional;
import org.dfra.flow.effector.DriveEffector;
import org.dfra.flow.effector.Effector;
import org.dfra.flow.effector.PanTiltEffector;
import org.dfra.flow.sensor.GPSSensor;
import org.dfra.module.Module;
import org.dfra.security.AccessRequest;
import org.dfra.security.Caller;
import org.dfra.security.Caller.Standing;
import org.dfra.security.Decision;
import org.dfra.security.Member;
import org.dfra.security.MemberRole;
import org.junit.jupiter.api.Test;

/** The first rule that matches decides, and a call that none matches is refused. */
class PolicyGuardTest {

  private static boolean permits(Policy policy, AccessRequest request) {
    return new PolicyGuard(policy).decide(request).isPermitted();
  }

  @Test
  void theFirstRuleThatMatchesDecides() {
    Policy denyFirst =
        policy("<deny name=\"no-anna\" member=\"anna\"/>", "<permit role=\"operator\"/>");
    Decision refused = new PolicyGuard(denyFirst).decide(call(ANNA, "execute"));
    assertThat(refused.isPermitted()).isFalse();
    assertThat(refused.rule()).isEqualTo("no-anna");
    assertThat(refused.reason())
        .isEqualTo(
            "rule no-anna of policy 1 of field denies Effector.execute on drive to operator anna"
                + " of field; ask an operator of field to change it");

    Policy permitFirst = policy("<permit role=\"operator\"/>", "<deny member=\"anna\"/>");
    assertThat(new PolicyGuard(permitFirst).decide(call(ANNA, "execute")))
        .isEqualTo(Decision.permit("line 2"));
  }

  @Test
  void refusesACallThatNoRuleMatchesAndGivesTheRemedy() {
    Decision decision =
        new PolicyGuard(policy("<permit role=\"operator\"/>")).decide(call(BOB, "execute"));

    assertThat(decision.isPermitted()).isFalse();
    assertThat(decision.rule()).isEqualTo("default");
    assertThat(decision.reason())
        .isEqualTo(
            "no rule of policy 1 of field permits Effector.execute on drive to observer bob of"
                + " field; ask an operator of field for a rule, or call as another member");
  }

  @Test
  void aPermitWithoutAStandingIsForValidMembersAndADenialForAll() {
    Caller expired = member(Standing.EXPIRED, MemberRole.OPERATOR, "anna");
    Policy permit = policy("<permit/>");
    assertThat(permits(permit, call(ANNA, "execute"))).isTrue();
    assertThat(permits(permit, call(OWN, "execute"))).isTrue();
    assertThat(permits(permit, call(expired, "execute"))).isFalse();
    assertThat(permits(permit, call(STRANGER, "execute"))).isFalse();

    Policy deny =
        policy("<deny member=\"anna\"/>", "<permit standing=\"member,expired\" kind=\"stop\"/>");
    assertThat(permits(deny, call(expired, "emergencyStop"))).isFalse();
    assertThat(permits(deny, call(BOB, "emergencyStop"))).isTrue();
  }

  @Test
  void aMemberOfAnotherTeamIsAStranger() {
    Member foreign = new Member("meadow", MemberRole.OPERATOR, "anna");
    Caller caller = new Caller(Standing.MEMBER, Optional.of(foreign), "192.0.2.9");

    assertThat(permits(policy("<permit role=\"operator\"/>"), call(caller, "execute"))).isFalse();
    assertThat(permits(policy("<permit standing=\"stranger\"/>"), call(caller, "execute")))
        .isTrue();
  }

  @Test
  void aRuleAboutAnInterfaceIsAboutObjectsThatHaveIt() {
    Policy drives = policy("<permit interface=\"DriveEffector\" method=\"execute\"/>");
    assertThat(permits(drives, call(ANNA, DriveEffector.class, "execute"))).isTrue();
    assertThat(permits(drives, call(ANNA, PanTiltEffector.class, "execute"))).isFalse();
    assertThat(permits(drives, call(ANNA, DriveEffector.class, "readiness"))).isFalse();

    Policy modules = policy("<permit interface=\"org.dfra.module.Module\"/>");
    assertThat(permits(modules, call(ANNA, GPSSensor.class, "readiness"))).isTrue();
    assertThat(permits(modules, call(ANNA, GPSSensor.class, "fix"))).isFalse();
  }

  @Test
  void anObjectOfUnknownClassIsRefusedWhereItMayHaveTheDeniedInterface() {
    Policy policy = policy("<deny interface=\"DriveEffector\"/>", "<permit/>");
    AccessRequest known =
        new AccessRequest(
            ANNA,
            "atrv1",
            "head",
            PanTilt.class,
            PolicyFixture.method(Effector.class, "emergencyStopState"));
    AccessRequest unknown =
        new AccessRequest(
            ANNA, "atrv1", "head", PolicyFixture.method(Effector.class, "emergencyStopState"));

    assertThat(permits(policy, known)).isTrue();
    assertThat(permits(policy, unknown)).isFalse();
    assertThat(permits(policy("<permit interface=\"DriveEffector\"/>"), unknown)).isFalse();
  }

  /** Only its interfaces matter. */
  private abstract static class PanTilt implements PanTiltEffector {}

  @Test
  void sameRobotComparesTheCallerWithTheCalledObject() {
    Policy policy = policy("<permit role=\"robot\" same-robot=\"yes\"/>");
    Caller other = member(Standing.MEMBER, MemberRole.ROBOT, "atrv2");
    assertThat(permits(policy, call(ATRV1, "execute"))).isTrue();
    assertThat(permits(policy, call(other, "execute"))).isFalse();

    Policy others = policy("<deny same-robot=\"no\" kind=\"command\"/>", "<permit/>");
    assertThat(permits(others, call(ATRV1, "execute"))).isTrue();
    assertThat(permits(others, call(other, "execute"))).isFalse();
    AccessRequest ofNoRobot =
        new AccessRequest(
            ATRV1, "", "", DriveEffector.class, PolicyFixture.method(Effector.class, "execute"));
    assertThat(permits(others, ofNoRobot)).as("not known to be the same").isFalse();
    assertThat(permits(policy, ofNoRobot)).isFalse();
  }

  @Test
  void namesMayHaveStars() {
    Policy policy = policy("<permit robot=\"atrv*\" object=\"gps_*,*rive\" kind=\"read\"/>");
    assertThat(permits(policy, call(BOB, "readiness"))).isTrue();
    AccessRequest laser =
        new AccessRequest(
            BOB, "atrv1", "laser", Module.class, PolicyFixture.method(Module.class, "readiness"));
    assertThat(permits(policy, laser)).isFalse();
    AccessRequest ofNoRobot =
        new AccessRequest(
            BOB, "", "drive", Module.class, PolicyFixture.method(Module.class, "readiness"));
    assertThat(permits(policy("<permit robot=\"*\"/>"), ofNoRobot))
        .as("an object of no robot matches no robot")
        .isFalse();
  }
}
