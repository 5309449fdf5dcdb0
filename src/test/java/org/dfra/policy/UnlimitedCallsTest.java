package org.dfra.policy;

import static org.assertj.core.api.Assertions.assertThat;

import java.lang.reflect.Method;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import org.dfra.river.security.budget.UnlimitedCalls;
import org.dfra.security.AccessRequest;
import org.dfra.security.Caller;
import org.dfra.security.Caller.Standing;
import org.dfra.security.Member;
import org.dfra.security.MemberRole;
import org.junit.jupiter.api.Test;

/** Which of all remote methods no budget limits: nobody adds one unnoticed. */
class UnlimitedCallsTest {

  private static final Caller OTTO =
      new Caller(
          Standing.MEMBER,
          Optional.of(new Member("field", MemberRole.OBSERVER, "otto")),
          "192.0.2.8");

  private static Set<String> unlimited(Caller caller) {
    UnlimitedCalls calls = new UnlimitedCalls();
    Set<String> found = new TreeSet<>();
    for (Class<?> type : RemoteInterfaces.ALL) {
      for (Method each : type.getMethods()) {
        if (calls.test(new AccessRequest(caller, "atrv1", "any", type, each))) {
          found.add(each.getDeclaringClass().getSimpleName() + "." + each.getName());
        }
      }
    }
    return found;
  }

  @Test
  void stopsLeasesAndTheSearchForRobotsAreNeverLimited() {
    Set<String> finding =
        Set.of(
            "Registrar.getEntryClasses",
            "Registrar.getFieldValues",
            "Registrar.getLocator",
            "Registrar.getServiceTypes",
            "Registrar.lookup",
            "ServiceProxyAccessor.getServiceProxy");
    Set<String> expected =
        new TreeSet<>(
            Set.of(
                "Effector.emergencyStop",
                "StopService.emergencyStop",
                "StoppableGroup.emergencyStop",
                "Behavior.cancel",
                "Behavior.cancelUnattended",
                "Behavior.pause",
                "Behavior.pauseUnattended",
                "Landlord.cancel",
                "Landlord.cancelAll",
                "Landlord.renew",
                "Landlord.renewAll",
                "Registrar.cancelEventLease",
                "Registrar.cancelLeases",
                "Registrar.cancelServiceLease",
                "Registrar.renewEventLease",
                "Registrar.renewLeases",
                "Registrar.renewServiceLease"));
    assertThat(unlimited(Caller.stranger("192.0.2.66"))).isEqualTo(expected);
    expected.addAll(finding);
    expected.addAll(
        Set.of( // who revokes a member, or corrects a budget, is not refused by one
            "TeamNews.numbers",
            "TeamNews.policy",
            "TeamNews.revocations",
            "TeamNews.takePolicy",
            "TeamNews.takeRevocations"));
    assertThat(unlimited(OTTO)).isEqualTo(expected);
  }

  @Test
  void nothingThatARobotsOwnProcessesCallIsLimited() {
    Caller own =
        new Caller(
            Standing.OWN, Optional.of(new Member("field", MemberRole.ROBOT, "atrv1")), "192.0.2.9");
    int methods = 0;
    for (Class<?> type : RemoteInterfaces.ALL) {
      for (Method each : type.getMethods()) {
        methods++;
        assertThat(new UnlimitedCalls().test(new AccessRequest(own, "atrv1", "any", type, each)))
            .as("%s", each)
            .isTrue();
      }
    }
    assertThat(methods).isGreaterThan(500);
  }
}
