package org.dfra.core.policy;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.dfra.core.policy.PolicyFixture.ANNA;
import static org.dfra.core.policy.PolicyFixture.BOB;
import static org.dfra.core.policy.PolicyFixture.STRANGER;
import static org.dfra.core.policy.PolicyFixture.call;
import static org.dfra.core.policy.PolicyFixture.member;
import static org.dfra.core.policy.PolicyFixture.policy;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicLong;
import org.dfra.core.budget.BudgetExceededException;
import org.dfra.core.budget.BudgetGuard;
import org.dfra.core.budget.BudgetUse;
import org.dfra.core.budget.ListenerShare;
import org.dfra.flow.effector.DriveEffector;
import org.dfra.security.AccessRequest;
import org.dfra.security.CallUse;
import org.dfra.security.Caller;
import org.dfra.security.Caller.Standing;
import org.dfra.security.Decision;
import org.dfra.security.Guard.Measurement;
import org.dfra.security.MemberRole;
import org.junit.jupiter.api.Test;

/** Budgets of a policy, from its text to decisions. */
class BudgetGuardTest {

  private static final String ALL = "<permit standing=\"own,member,expired,stranger\"/>";
  private static final String TEN_CALLS =
      "<budget name=\"observers\" role=\"observer\" calls=\"10/s\"/>";
  private static final Caller CARLA = member(Standing.MEMBER, MemberRole.OBSERVER, "carla");

  private final AtomicLong nanos = new AtomicLong(Long.MAX_VALUE - 1000); // it will overflow
  private final List<Long> waits = new ArrayList<>();

  private BudgetGuard guard(PolicyGuard policy) {
    return new BudgetGuard(
        policy,
        () -> policy.policy().budgets(),
        "atrv1",
        request -> request.method().getName().equals("emergencyStop"),
        nanos::get,
        waits::add);
  }

  private BudgetGuard guard(String... budgets) {
    List<String> lines = new ArrayList<>(List.of(ALL));
    lines.addAll(List.of(budgets));
    return guard(new PolicyGuard(policy(lines.toArray(String[]::new))));
  }

  private void pass(long millis) {
    nanos.addAndGet(TimeUnit.MILLISECONDS.toNanos(millis));
  }

  private static int permitted(BudgetGuard guard, AccessRequest request, int calls) {
    int permitted = 0;
    for (int i = 0; i < calls; i++) {
      permitted += guard.decide(request).isPermitted() ? 1 : 0;
    }
    return permitted;
  }

  private static AccessRequest of(Caller caller, String object, String method) {
    return new AccessRequest(
        caller,
        "atrv1",
        object,
        DriveEffector.class,
        PolicyFixture.method(DriveEffector.class, method));
  }

  @Test
  void refusesTheCallsOfOneCallerBeyondItsBudgetWithASentence() {
    BudgetGuard guard = guard(TEN_CALLS);
    assertThat(permitted(guard, call(BOB, "driveState"), 100)).isEqualTo(10);
    Decision refused = guard.decide(call(BOB, "driveState"));
    assertThat(refused.rule()).isEqualTo("budget observers");
    assertThat(refused.reason())
        .isEqualTo(
            "observer bob has used up the 10 calls/s that it allows each caller; call less often,"
                + " again in 1 s at the latest, or ask an operator for a larger budget");
    assertThat(permitted(guard, call(CARLA, "driveState"), 100)).as("another one").isEqualTo(10);
    assertThat(permitted(guard, call(ANNA, "driveState"), 100)).as("an operator").isEqualTo(100);
    pass(500);
    assertThat(permitted(guard, call(BOB, "driveState"), 100)).as("after 0.5 s").isEqualTo(5);
    BudgetUse use = guard.use().get(0);
    assertThat(use.owner()).isEqualTo("observer bob");
    assertThat(use.refused()).isEqualTo(90 + 1 + 95);
  }

  @Test
  void neverRefusesOrSlowsACallThatIsNotLimited() {
    for (String exceeded : List.of("refuse", "slow")) {
      BudgetGuard guard =
          guard(
              "<budget calls=\"1/s\" bytes=\"1B/s\" processor-time=\"1ms/s\" exceeded=\""
                  + exceeded
                  + "\"/>",
              "<budget object=\"*\" per=\"object\" calls=\"1/s\" exceeded=\"" + exceeded + "\"/>");
      AccessRequest read = call(ANNA, "driveState");
      int unused = permitted(guard, read, 20);
      guard.ended(read, new CallUse(1_000_000, TimeUnit.SECONDS.toNanos(5)));
      assertThat(guard.decide(read).isPermitted()).isFalse();
      waits.clear();
      assertThat(permitted(guard, call(ANNA, "emergencyStop"), 50)).isEqualTo(50);
      assertThat(waits).isEmpty();
      assertThat(guard.decide(call(ANNA, "releaseEmergencyStop")).isPermitted())
          .as("a release moves a robot")
          .isFalse();
    }
  }

  @Test
  void slowsACallUntilItsBudgetHasRoomAndRefusesItIfThatIsTooLong() {
    BudgetGuard guard = guard("<budget role=\"observer\" calls=\"10/s\" exceeded=\"slow\"/>");
    AccessRequest read = call(BOB, "driveState");
    assertThat(permitted(guard, read, 10)).isEqualTo(10);
    assertThat(waits).isEmpty();
    for (int i = 0; i < 5; i++) {
      assertThat(guard.decide(read).isPermitted()).isTrue();
    }
    assertThat(waits.stream().map(TimeUnit.NANOSECONDS::toMillis))
        .as("each waits for its turn")
        .containsExactly(100L, 200L, 300L, 400L, 500L);
    assertThat(guard.decide(read).isPermitted()).as("the sixth would wait 0.6 s").isFalse();
    BudgetUse use = guard.use().get(0);
    assertThat(use.slowed()).isEqualTo(5);
    assertThat(use.refused()).isEqualTo(1);
  }

  @Test
  void bytesAndProcessorTimeOfACallCountAgainstTheNextOnes() {
    BudgetGuard bytes = guard("<budget role=\"observer\" bytes=\"10kB/s\"/>");
    AccessRequest image = call(BOB, "driveState");
    assertThat(bytes.measurement()).isEqualTo(Measurement.BYTES);
    assertThat(bytes.decide(image).isPermitted()).isTrue();
    bytes.ended(image, new CallUse(30_000, 0));
    assertThat(bytes.decide(image).reason()).contains("the 10 kB/s that it allows", "in 2 s at");
    pass(1900);
    assertThat(bytes.decide(image).isPermitted()).isFalse();
    pass(200);
    assertThat(bytes.decide(image).isPermitted()).isTrue();
    bytes.ended(image, new CallUse(100_000_000, 0));
    assertThat(bytes.decide(image).reason()).as("at most").contains("in 10 s at the latest");

    BudgetGuard time = guard("<budget role=\"observer\" processor-time=\"50ms/s\"/>");
    assertThat(time.measurement()).isEqualTo(Measurement.BYTES_AND_PROCESSOR_TIME);
    assertThat(time.decide(image).isPermitted()).isTrue();
    time.ended(image, new CallUse(100, TimeUnit.MILLISECONDS.toNanos(80)));
    assertThat(time.decide(image).reason()).contains("the 50 ms/s of processor time that it");
    pass(700);
    assertThat(time.decide(image).isPermitted()).isTrue();
  }

  @Test
  void allCallersShareTheBudgetOfAnObject() {
    BudgetGuard guard =
        guard("<budget name=\"drives\" per=\"object\" object=\"drive*\" calls=\"10/s\"/>");
    assertThat(permitted(guard, of(BOB, "drive", "driveState"), 6)).isEqualTo(6);
    assertThat(permitted(guard, of(CARLA, "drive", "driveState"), 6)).isEqualTo(4);
    assertThat(guard.decide(of(CARLA, "drive", "driveState")).reason())
        .startsWith("drive has used up the 10 calls/s that it allows all callers together");
    assertThat(permitted(guard, of(CARLA, "drive2", "driveState"), 6)).isEqualTo(6);
    assertThat(permitted(guard, of(CARLA, "gps", "driveState"), 60)).isEqualTo(60);
    assertThat(permitted(guard, of(CARLA, "", "driveState"), 60)).as("nameless").isEqualTo(60);
  }

  @Test
  void aCallThatOneBudgetRefusesCostsNothingOfAnother() {
    BudgetGuard guard =
        guard(
            "<budget name=\"each\" role=\"observer\" calls=\"10/s\"/>",
            "<budget name=\"drive\" per=\"object\" object=\"drive\" calls=\"1/s\"/>");
    assertThat(permitted(guard, of(BOB, "drive", "driveState"), 30)).isEqualTo(1);
    assertThat(permitted(guard, of(BOB, "gps", "driveState"), 30)).isEqualTo(9);
  }

  @Test
  void aGreedyCallerTakesNothingFromAnother() {
    BudgetGuard guard = guard("<budget role=\"observer\" calls=\"100/s\"/>");
    int greedy = 0;
    int polite = 0;
    for (int millis = 0; millis < 60_000; millis += 20) {
      greedy += permitted(guard, call(BOB, "driveState"), 200); // 10 000 calls/s
      polite += permitted(guard, call(CARLA, "driveState"), 1); // 50 calls/s
      pass(20);
    }
    assertThat(polite).as("50 calls/s for 60 s").isEqualTo(3000);
    assertThat(greedy).as("100 calls/s for 60 s, and 100 at first").isBetween(6000, 6100);
  }

  @Test
  void limitsListenersAndKeepsTheirCountWhenThePolicyIsReplaced() throws Exception {
    String four = "<budget name=\"few\" role=\"observer\" listeners=\"4\"/>";
    PolicyGuard policy = new PolicyGuard(policy(ALL, four));
    BudgetGuard guard = guard(policy);
    List<ListenerShare> held = new ArrayList<>();
    for (int i = 0; i < 4; i++) {
      held.add(guard.admitListener(BOB, "gps"));
    }
    String refusal = "observer bob has 4 of at most 4 listeners of budget few; close some of them";
    assertThatThrownBy(() -> guard.admitListener(BOB, "drive"))
        .isInstanceOf(BudgetExceededException.class)
        .hasMessageContaining(refusal);
    held.add(guard.admitListener(CARLA, "gps"));
    held.add(guard.admitListener(ANNA, "gps"));
    assertThat(policy.replace(PolicyFixture.version(2, ALL, four))).isTrue();
    assertThatThrownBy(() -> guard.admitListener(BOB, "drive")).hasMessageContaining(refusal);
    held.get(0).close();
    held.get(0).close();
    held.add(guard.admitListener(BOB, "drive"));
    assertThatThrownBy(() -> guard.admitListener(BOB, "drive")).hasMessageContaining(refusal);
  }

  @Test
  void aListenerIsOutOfBytesUntilWhatWasSentToItIsPaidFor() throws Exception {
    BudgetGuard guard = guard("<budget role=\"observer\" bytes=\"10kB/s\"/>");
    ListenerShare bob = guard.admitListener(BOB, "gps");
    ListenerShare anna = guard.admitListener(ANNA, "gps");
    bob.count(30_000, 3);
    anna.count(30_000, 0);
    assertThat(bob.isOutOfBytes()).isTrue();
    assertThat(anna.isOutOfBytes()).isFalse();
    assertThat(guard.decide(call(BOB, "driveState")).isPermitted()).as("its calls too").isFalse();
    pass(2100);
    assertThat(bob.isOutOfBytes()).isFalse();
    BudgetUse use = guard.use().get(0);
    assertThat(use.thinned()).isEqualTo(3);
    assertThat(use.bytes()).as("over 10 s").isEqualTo(3000);
    assertThat(use.listeners()).isEqualTo(1);
  }

  @Test
  void followsThePolicyAndMeasuresNothingWithoutABudget() {
    PolicyGuard policy = new PolicyGuard(policy(ALL));
    BudgetGuard guard = guard(policy);
    assertThat(guard.measurement()).isEqualTo(Measurement.NONE);
    assertThat(permitted(guard, call(BOB, "driveState"), 1000)).isEqualTo(1000);
    assertThat(policy.replace(PolicyFixture.version(2, ALL, TEN_CALLS))).isTrue();
    assertThat(guard.measurement()).isEqualTo(Measurement.BYTES);
    assertThat(permitted(guard, call(BOB, "driveState"), 1000)).isEqualTo(10);
    String elsewhere = "<budget robot=\"atrv2\" calls=\"10/s\"/>";
    assertThat(policy.replace(PolicyFixture.version(3, ALL, elsewhere))).isTrue();
    assertThat(guard.measurement()).as("of another robot").isEqualTo(Measurement.NONE);
    assertThat(permitted(guard, call(BOB, "driveState"), 1000)).isEqualTo(1000);
    String radios = "<radio max=\"1MB/s\" robot=\"atrv2\"/><radio max=\"200kB/s\"/>";
    assertThat(policy.replace(PolicyFixture.version(4, ALL, radios))).isTrue();
    assertThat(guard.radio()).hasValue(200_000.0);
  }

  @Test
  void distinguishesStrangersByAddressWithinBoundedMemory() {
    BudgetGuard guard = guard("<budget name=\"them\" standing=\"stranger\" calls=\"10/s\"/>");
    assertThat(permitted(guard, call(STRANGER, "driveState"), 100)).isEqualTo(10);
    for (int i = 0; i < 5000; i++) {
      Caller other = Caller.stranger("198.51." + i / 250 + "." + i % 250);
      Decision unused = guard.decide(call(other, "driveState"));
    }
    assertThat(guard.use()).hasSizeLessThanOrEqualTo(513);
    assertThat(guard.decide(call(STRANGER, "driveState")).isPermitted()).isFalse();
    pass(20_000);
    assertThat(permitted(guard, call(STRANGER, "driveState"), 100)).isEqualTo(10);
  }
}
