package org.dfra.policy;

import static org.assertj.core.api.Assertions.assertThat;

import java.lang.reflect.Method;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.Optional;
import org.dfra.core.policy.BuiltInPolicies;
import org.dfra.core.policy.PolicyGuard;
import org.dfra.core.policy.PolicyXml;
import org.dfra.core.policy.method.InterfaceCatalogue;
import org.dfra.security.AccessRequest;
import org.dfra.security.Caller;
import org.dfra.security.Caller.Standing;
import org.dfra.security.Member;
import org.dfra.security.MemberRole;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * Each role asks for each remote method under the policies that DFRA brings. {@link RoleMatrixTest}
 * calls them.
 */
class BuiltInPoliciesTest {

  private static final String ROBOT = "atrv1";

  private static Caller caller(Standing standing, MemberRole role, String name) {
    return new Caller(standing, Optional.of(new Member("field", role, name)), "192.0.2.7");
  }

  @Test
  void theStandardPolicyPermitsEachRoleWhatItNeedsAndNothingElse() {
    PolicyGuard guard = new PolicyGuard(BuiltInPolicies.standard("field"));
    int permitted = 0;
    int refused = 0;
    for (Caller caller :
        new Caller[] {
          caller(Standing.OWN, MemberRole.ROBOT, ROBOT),
          caller(Standing.OWN, MemberRole.OPERATOR, "anna"),
          caller(Standing.MEMBER, MemberRole.OPERATOR, "anna"),
          caller(Standing.MEMBER, MemberRole.OBSERVER, "bob"),
          caller(Standing.MEMBER, MemberRole.ROBOT, "atrv2"),
          caller(Standing.EXPIRED, MemberRole.OPERATOR, "anna"),
          Caller.stranger("192.0.2.66")
        }) {
      for (Class<?> type : RemoteInterfaces.ALL) {
        for (Method method : type.getMethods()) {
          for (String robot : new String[] {ROBOT, ""}) {
            boolean isPermitted =
                guard
                    .decide(new AccessRequest(caller, robot, "object", type, method))
                    .isPermitted();
            assertThat(isPermitted)
                .as("%s calls %s of %s of \"%s\"", caller, method, type.getSimpleName(), robot)
                .isEqualTo(ExpectedPermissions.permit(caller, type, method, robot));
            permitted += isPermitted ? 1 : 0;
            refused += isPermitted ? 0 : 1;
          }
        }
      }
    }
    assertThat(permitted).isGreaterThan(1000);
    assertThat(refused).isGreaterThan(1000);
  }

  @ParameterizedTest
  @CsvSource({
    "OPERATOR, org.dfra.river.remote.effector.RemoteDriveEffector, execute, true",
    "ROBOT, org.dfra.river.remote.effector.RemoteDriveEffector, execute, false",
    "OBSERVER, org.dfra.river.remote.effector.RemoteDriveEffector, execute, false",
    "OBSERVER, org.dfra.river.remote.effector.RemoteDriveEffector, acquireCommandLease, false",
    "OBSERVER, org.dfra.river.remote.effector.RemoteDriveEffector, acquireLease, true",
    "OBSERVER, org.dfra.river.remote.effector.RemoteDriveEffector, subscribe, true",
    "OBSERVER, org.dfra.river.remote.effector.RemoteDriveEffector, emergencyStop, true",
    "OBSERVER, org.dfra.river.remote.effector.RemoteDriveEffector, releaseEmergencyStop, false",
    "ROBOT, org.dfra.river.remote.effector.RemoteDriveEffector, releaseEmergencyStop, false",
    "OPERATOR, org.dfra.river.remote.effector.RemoteDriveEffector, releaseEmergencyStop, true",
    "ROBOT, org.dfra.recruit.river.RemoteRecruitmentAgent, notify, true",
    "ROBOT, org.dfra.recruit.river.RemoteRecruitmentAgent, callForHelp, false",
    "OBSERVER, org.dfra.recruit.river.RemoteRecruitmentAgent, notify, false",
    "ROBOT, org.dfra.river.remote.behavior.RemoteGoToWaypoint, pursueUnattended, false",
    "OBSERVER, org.dfra.river.remote.behavior.RemoteGoToWaypoint, cancel, false",
    "ROBOT, org.dfra.river.remote.ModuleAdmin, leases, true",
    "ROBOT, org.dfra.river.remote.ModuleAdmin, destroy, false",
    "OPERATOR, java.rmi.activation.ActivationSystem, registerGroup, false",
    "OBSERVER, java.rmi.activation.Activator, activate, true",
    "OBSERVER, org.dfra.river.phoenix.stop.StopService, emergencyStop, true",
    "OBSERVER, com.sun.jini.landlord.Landlord, renew, true",
  })
  void membersOfEachRoleMay(MemberRole role, String type, String method, boolean isPermitted) {
    Class<?> called = RemoteInterfaces.load(type);
    Method found =
        Arrays.stream(called.getMethods())
            .filter(each -> each.getName().equals(method))
            .findFirst()
            .orElseThrow();
    Caller caller = caller(Standing.MEMBER, role, "other");

    assertThat(
            new PolicyGuard(BuiltInPolicies.standard("field"))
                .decide(new AccessRequest(caller, ROBOT, "object", called, found))
                .isPermitted())
        .isEqualTo(isPermitted);
  }

  @Test
  void theClosedPolicyPermitsOthersOnlyToStopAndToKeepAndEndLeases() {
    PolicyGuard guard = new PolicyGuard(BuiltInPolicies.closed("field"));
    for (Class<?> type : RemoteInterfaces.ALL) {
      for (Method method : type.getMethods()) {
        boolean isLease =
            method.getDeclaringClass().getSimpleName().equals("Landlord")
                || method.getName().matches("(renew|cancel)(Service|Event)?Leases?");
        boolean isStop = method.getName().equals("emergencyStop");
        for (Caller caller :
            new Caller[] {
              caller(Standing.MEMBER, MemberRole.OPERATOR, "anna"),
              caller(Standing.EXPIRED, MemberRole.ROBOT, "atrv2"),
              Caller.stranger("192.0.2.66")
            }) {
          assertThat(
                  guard
                      .decide(new AccessRequest(caller, ROBOT, "object", type, method))
                      .isPermitted())
              .as("%s calls %s", caller, method)
              .isEqualTo(isLease || isStop);
        }
        Caller own = caller(Standing.OWN, MemberRole.ROBOT, ROBOT);
        assertThat(
                guard.decide(new AccessRequest(own, ROBOT, "object", type, method)).isPermitted())
            .isTrue();
      }
    }
  }

  @Test
  void theTextForATeamIsThatPolicyWithItsNameAndVersion() {
    String text = BuiltInPolicies.standardText("meadow", 7);
    assertThat(
            PolicyXml.read(
                text.getBytes(StandardCharsets.UTF_8), "policy.xml", InterfaceCatalogue.builtIn()))
        .hasToString("policy 7 of meadow");
  }
}
