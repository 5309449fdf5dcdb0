package org.dfra.core.policy;

import static org.assertj.core.api.Assertions.assertThat;
import static org.dfra.core.policy.PolicyFixture.ANNA;
import static org.dfra.core.policy.PolicyFixture.ATRV1;
import static org.dfra.core.policy.PolicyFixture.BOB;
import static org.dfra.core.policy.PolicyFixture.call;
import static org.dfra.core.policy.PolicyFixture.policy;
import static org.dfra.core.policy.PolicyFixture.version;

import java.time.InstantSource;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.dfra.core.budget.BudgetGuard;
import org.dfra.core.budget.Budgets;
import org.dfra.security.AccessRequest;
import org.dfra.security.Behalf;
import org.dfra.security.Caller;
import org.dfra.security.Guard;
import org.dfra.security.Permissions;
import org.junit.jupiter.api.Test;

/** What a guard says about earlier calls when its policy was replaced. */
class PermissionsTest {

  private static final AccessRequest ANNAS = call(ANNA, "execute");
  private static final AccessRequest BOBS = call(BOB, "execute");

  private final SettableFacts facts = new SettableFacts();
  private final List<DecisionRecord> observed = new ArrayList<>();
  private final ConfirmationRequests requests =
      new ConfirmationRequests(System::nanoTime, new Random(2026), () -> {});

  private PolicyGuard guard(String... rules) {
    return new PolicyGuard(
        policy(rules), facts, requests, observed::add, InstantSource.system(), System::nanoTime);
  }

  @Test
  void theNewPolicyDecidesAboutEarlierCalls() {
    PolicyGuard guard = guard("<permit/>");
    Permissions permissions = guard.permissions();
    assertThat(permissions.isStillPermitted(BOBS)).isTrue();
    assertThat(permissions.version()).isEqualTo(1);
    List<Boolean> bobs = new ArrayList<>();
    Runnable end = permissions.onReplacement(() -> bobs.add(permissions.isStillPermitted(BOBS)));
    assertThat(guard.replace(version(2, "<permit role=\"operator\"/>"))).isTrue();
    assertThat(bobs).as("by the new policy").containsExactly(false);
    assertThat(permissions.isStillPermitted(ANNAS)).isTrue();
    assertThat(permissions.version()).isEqualTo(2);
    assertThat(guard.replace(version(2, "<permit role=\"operator\"/>"))).isFalse();
    assertThat(bobs).as("nothing was replaced").hasSize(1);
    end.run();
    assertThat(guard.replace(version(3, "<permit/>"))).isTrue();
    assertThat(bobs).hasSize(1);
  }

  @Test
  void ratesAndConfirmationsCountAsMetAndAreLeftAlone() {
    PolicyGuard guard =
        guard(
            "<permit role=\"operator\"><ask/><log/></permit>",
            "<permit role=\"observer\"><rate max=\"1\" per=\"1h\"/></permit>");
    assertThat(guard.decide(BOBS).isPermitted()).isTrue();
    assertThat(guard.decide(BOBS).isPermitted()).as("its rate is used up").isFalse();
    observed.clear();
    for (int i = 0; i < 3; i++) {
      assertThat(guard.permissions().isStillPermitted(BOBS)).isTrue();
      assertThat(guard.permissions().isStillPermitted(ANNAS)).isTrue();
    }
    assertThat(requests.pending()).as("no operator is asked").isEmpty();
    assertThat(observed).as("nobody has called").isEmpty();
    guard = guard("<permit role=\"observer\"><rate max=\"1\" per=\"1h\"/></permit>");
    assertThat(guard.permissions().isStillPermitted(BOBS)).isTrue();
    assertThat(guard.decide(BOBS).isPermitted()).as("which counts no call").isTrue();
  }

  @Test
  void conditionsAreThoseOfNow() {
    Permissions permissions =
        guard("<permit><while fact=\"load\" is=\"none\"/></permit>").permissions();
    assertThat(permissions.isStillPermitted(ANNAS)).as("it is unknown").isFalse();
    facts.named.put("load", "none");
    assertThat(permissions.isStillPermitted(ANNAS)).isTrue();
    facts.named.put("load", "full");
    assertThat(permissions.isStillPermitted(ANNAS)).isFalse();
  }

  @Test
  void aCallOnSomebodysBehalfNeedsBoth() {
    Caller caller = ATRV1.onBehalfOf(Behalf.of(ANNA.member().orElseThrow()));
    AccessRequest delegated = call(caller, "execute");
    PolicyGuard guard =
        guard("<permit role=\"robot\" for-member=\"anna\"/>", "<permit role=\"operator\"/>");
    assertThat(guard.permissions().isStillPermitted(delegated)).isTrue();
    guard.replace(version(2, "<permit role=\"operator\"/>"));
    assertThat(guard.permissions().isStillPermitted(delegated)).as("not the bearer").isFalse();
    guard.replace(version(3, "<permit role=\"robot\" for-member=\"anna\"/>"));
    assertThat(guard.permissions().isStillPermitted(delegated)).as("not anna").isFalse();
  }

  @Test
  void guardsAroundAnotherPassItOn() {
    PolicyGuard guard = guard("<permit/>");
    Guard budgets = new BudgetGuard(guard, () -> Budgets.NONE, "atrv1", request -> false);
    assertThat(budgets.permissions()).isSameAs(guard.permissions());
    Guard lasting = request -> guard.decide(request);
    assertThat(lasting.permissions().isStillPermitted(ANNAS)).isTrue();
    assertThat(lasting.permissions().version()).isZero();
  }
}
