package org.dfra.core.policy;

import static org.assertj.core.api.Assertions.assertThat;
import static org.dfra.core.policy.PolicyFixture.ANNA;
import static org.dfra.core.policy.PolicyFixture.BOB;
import static org.dfra.core.policy.PolicyFixture.STRANGER;
import static org.dfra.core.policy.PolicyFixture.call;
import static org.dfra.core.policy.PolicyFixture.policy;

import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicLong;
import org.dfra.core.budget.BudgetGuard;
import org.dfra.core.policy.ConfirmationRequests.PendingConfirmation;
import org.dfra.core.policy.Obligations.RateLimit;
import org.dfra.security.Caller;
import org.dfra.security.Decision;
import org.junit.jupiter.api.Test;

/** Rates, confirmations and reports of decisions. */
class ObligationsTest {

  private static final Instant NOON = Instant.parse("2026-11-28T12:00:00Z");
  private static final String FIVE_A_SECOND =
      "<permit name=\"slow\" standing=\"member,stranger\"><rate max=\"5\" per=\"1s\"/></permit>";

  private final AtomicLong nanos = new AtomicLong(Long.MAX_VALUE - 1000); // it will overflow
  private final AtomicInteger asked = new AtomicInteger();
  private final ConfirmationRequests requests =
      new ConfirmationRequests(nanos::get, new Random(2026), asked::incrementAndGet);
  private final List<DecisionRecord> observed = new ArrayList<>();

  private PolicyGuard guard(String... lines) {
    return new PolicyGuard(
        policy(lines),
        PolicyFacts.none(),
        requests,
        observed::add,
        InstantSource.fixed(NOON),
        nanos::get);
  }

  private void pass(long millis) {
    nanos.addAndGet(TimeUnit.MILLISECONDS.toNanos(millis));
  }

  @Test
  void permitsAsManyCallsAsTheRateAndRefusesTheNext() {
    PolicyGuard guard = guard(FIVE_A_SECOND);
    for (int i = 0; i < 5; i++) {
      assertThat(guard.decide(call(ANNA, "execute")).isPermitted()).as("call %d", i).isTrue();
      pass(100);
    }
    Decision refused = guard.decide(call(ANNA, "execute"));
    assertThat(refused.isPermitted()).isFalse();
    assertThat(refused.rule()).isEqualTo("slow");
    assertThat(refused.reason()).contains("at most 5 calls in 1 s; call less often");
    assertThat(guard.decide(call(BOB, "execute")).isPermitted()).as("another caller").isTrue();

    pass(499);
    assertThat(guard.decide(call(ANNA, "execute")).isPermitted()).isFalse();
    pass(1);
    assertThat(guard.decide(call(ANNA, "execute")).isPermitted())
        .as("1 s after the first")
        .isTrue();
  }

  @Test
  void noPeriodHasMoreCallsThanTheRate() {
    PolicyGuard guard = guard(FIVE_A_SECOND);
    Random random = new Random(2004);
    List<Long> times = new ArrayList<>();
    for (int i = 0; i < 2000; i++) {
      if (guard.decide(call(ANNA, "execute")).isPermitted()) {
        times.add(nanos.get());
      }
      pass(random.nextInt(300));
    }
    assertThat(times).hasSizeGreaterThan(1000);
    for (int i = 5; i < times.size(); i++) {
      assertThat(times.get(i) - times.get(i - 5)).isGreaterThanOrEqualTo(1_000_000_000L);
    }
  }

  @Test
  void countsFewerCallersThanThereAreAddressesOfStrangers() {
    CallRateLimiter limiter =
        new CallRateLimiter(new RateLimit(1, Duration.ofSeconds(1)), nanos::get);
    int permitted = 0;
    for (int i = 0; i < 10_000; i++) {
      permitted += limiter.tryCall(call(Caller.stranger("2001:db8::" + i), "readiness")) ? 1 : 0;
    }
    assertThat(permitted).isEqualTo(CallRateLimiter.MAX_CALLERS + 1);
    pass(1000);
    assertThat(limiter.tryCall(call(Caller.stranger("2001:db8::ffff"), "readiness")))
        .as("those before no longer count")
        .isTrue();
  }

  @Test
  void whatMustBeConfirmedIsRefusedUntilAnOperatorConfirmsIt() {
    PolicyGuard guard = guard("<permit name=\"ask-first\"><ask/></permit>");
    Decision refused = guard.decide(call(ANNA, "execute"));
    assertThat(refused.isPermitted()).isFalse();
    assertThat(refused.reason()).contains("only when an operator has confirmed it");

    List<PendingConfirmation> pending = requests.pending();
    assertThat(pending).hasSize(1);
    assertThat(pending.get(0).request().caller()).isEqualTo(ANNA);
    assertThat(asked).as("somebody is to show it to operators").hasValue(1);
    assertThat(requests.answer(pending.get(0).id(), true)).isTrue();
    assertThat(requests.pending()).isEmpty();
    assertThat(guard.decide(call(ANNA, "readiness")).isPermitted()).as("another call").isFalse();
    assertThat(guard.decide(call(BOB, "execute")).isPermitted()).as("another caller").isFalse();
    assertThat(guard.decide(call(ANNA, "execute")).isPermitted()).isTrue();
    assertThat(guard.decide(call(ANNA, "execute")).isPermitted()).as("a second time").isFalse();
    assertThat(requests.answer(pending.get(0).id(), true)).as("the old request").isFalse();
  }

  private String requestOf(String method) {
    return requests.pending().stream()
        .filter(each -> each.request().methodName().endsWith("." + method))
        .findFirst()
        .orElseThrow()
        .id();
  }

  @Test
  void aConfirmationThatIsNotUsedEnds() {
    PolicyGuard guard = guard("<permit name=\"ask-first\"><ask/></permit>");
    guard.decide(call(ANNA, "execute"));
    assertThat(requests.answer(requestOf("execute"), true)).isTrue();
    pass(1000L * ConfirmationRequests.KEPT_SECONDS);
    assertThat(guard.decide(call(ANNA, "execute")).isPermitted()).isFalse();
  }

  @Test
  void whatAnOperatorHasRefusedIsNotAskedForAgainForAWhile() {
    PolicyGuard guard = guard("<permit name=\"ask-first\"><ask/></permit>");
    guard.decide(call(ANNA, "execute"));
    assertThat(requests.answer(requestOf("execute"), false)).isTrue();
    Decision refused = guard.decide(call(ANNA, "execute"));
    assertThat(refused.isPermitted()).isFalse();
    assertThat(refused.reason()).contains("one has refused it");
    assertThat(requests.pending()).isEmpty();
    pass(1000L * ConfirmationRequests.KEPT_SECONDS);
    guard.decide(call(ANNA, "execute"));
    assertThat(requests.pending()).hasSize(1);
  }

  @Test
  void aCallThatIsMadeTooOftenUsesNoConfirmation() {
    PolicyGuard guard = guard("<permit name=\"both\"><ask/><rate max=\"1\" per=\"10s\"/></permit>");
    guard.decide(call(ANNA, "execute"));
    assertThat(requests.answer(requestOf("execute"), true)).isTrue();
    assertThat(guard.decide(call(ANNA, "execute")).isPermitted()).isTrue();
    guard.decide(call(ANNA, "execute"));
    assertThat(requests.answer(requestOf("execute"), true)).isTrue();
    assertThat(guard.decide(call(ANNA, "execute")).reason()).contains("call less often");
    pass(10_000);
    assertThat(guard.decide(call(ANNA, "execute")).isPermitted()).isTrue();
  }

  @Test
  void aStopNeedsNoConfirmationAndHasNoRate() {
    PolicyGuard guard = guard("<permit><ask/><rate max=\"1\" per=\"1h\"/></permit>");
    for (int i = 0; i < 3; i++) {
      assertThat(guard.decide(call(BOB, "emergencyStop")).isPermitted()).as("stop %d", i).isTrue();
    }
    assertThat(requests.pending()).isEmpty();
    assertThat(guard.decide(call(ANNA, "releaseEmergencyStop")).isPermitted()).isFalse();
  }

  @Test
  void aCallThatABudgetRefusesUsesNoConfirmation() {
    PolicyGuard policy =
        guard(
            "<permit name=\"ask-first\" interface=\"Effector\" method=\"execute\"><ask/></permit>",
            "<permit/><budget calls=\"1/s\"/>");
    BudgetGuard guard =
        new BudgetGuard(
            policy, () -> policy.policy().budgets(), "atrv1", r -> false, nanos::get, w -> {});
    guard.decide(call(ANNA, "execute"));
    assertThat(requests.answer(requestOf("execute"), true)).isTrue();
    assertThat(guard.decide(call(ANNA, "readiness")).isPermitted()).isTrue();
    Decision refused = guard.decide(call(ANNA, "execute"));
    assertThat(refused.rule()).startsWith("budget ");
    assertThat(observed.get(observed.size() - 1).decision())
        .as("what the log says")
        .isEqualTo(refused);
    pass(1000);
    assertThat(guard.decide(call(ANNA, "execute")).isPermitted())
        .as("the confirmation is still there")
        .isTrue();
  }

  @Test
  void theGuardSaysWhatADecisionObligesTo() {
    PolicyGuard guard = guard("<permit name=\"noted\" role=\"operator\"><log/><notify/></permit>");
    assertThat(guard.obligations(guard.decide(call(ANNA, "execute"))))
        .containsExactly("log", "notify");
    assertThat(guard.obligations(guard.decide(call(STRANGER, "execute")))).isEmpty();
  }

  @Test
  void requestsForConfirmationAreBoundedAndEnd() {
    PolicyGuard guard = guard("<permit standing=\"stranger\"><ask/></permit>");
    for (int i = 0; i < 1000; i++) {
      guard.decide(call(Caller.stranger("192.0.2." + i), "execute"));
    }
    assertThat(requests.pending()).hasSize(ConfirmationRequests.MAX_REQUESTS);
    pass(1000L * ConfirmationRequests.KEPT_SECONDS);
    assertThat(requests.pending()).isEmpty();
    for (String method : new String[] {"execute", "readiness", "history", "tests", "frame"}) {
      guard.decide(call(STRANGER, method));
    }
    assertThat(requests.pending()).hasSize(ConfirmationRequests.MAX_OF_CALLER);
  }

  @Test
  void aListenerObservesEachDecisionWithItsRuleAndObligations() {
    PolicyGuard guard = guard("<permit name=\"noted\" role=\"operator\"><log/><notify/></permit>");
    guard.decide(call(ANNA, "execute"));
    guard.decide(call(ANNA, "execute"));
    guard.decide(call(STRANGER, "execute"));

    assertThat(observed).hasSize(3);
    DecisionRecord first = observed.get(0);
    assertThat(first.time()).isEqualTo(NOON);
    assertThat(first.request()).isEqualTo(call(ANNA, "execute"));
    assertThat(first.decision()).isEqualTo(Decision.permit("noted"));
    assertThat(first.obligations()).isEqualTo(new Obligations(null, true, true, false));
    assertThat(DecisionLog.sentence(first))
        .isEqualTo(
            "Permitted Effector.execute on drive to operator anna of field (192.0.2.7) by rule"
                + " noted of policy version 1.");
    assertThat(observed.get(2).decision().rule()).isEqualTo(Policy.DEFAULT_RULE);
    assertThat(observed.get(2).request().caller()).isEqualTo(STRANGER);
  }

  @Test
  void theLogHasABoundedNumberOfLinesAndSaysHowManyItOmits() {
    DecisionLog log = new DecisionLog(nanos::get);
    for (int i = 0; i < DecisionLog.MAX_LINES; i++) {
      assertThat(log.countLine()).as("line %d", i).isZero();
    }
    assertThat(log.countLine()).isEqualTo(-1);
    assertThat(log.countLine()).isEqualTo(-1);
    pass(1000);
    assertThat(log.countLine()).as("omitted before it").isEqualTo(2);
    assertThat(log.countLine()).isZero();
  }

  /** The disk of a log may stand still, and a stop must not wait for it. */
  @Test
  void aDecisionDoesNotWaitForTheLog() {
    List<Runnable> waiting = new ArrayList<>();
    DecisionLog log =
        new DecisionLog(
            nanos::get,
            line -> {
              if (waiting.size() == 2) {
                throw new RejectedExecutionException("the log stands still");
              }
              waiting.add(line);
            });
    PolicyGuard guard =
        new PolicyGuard(
            policy("<permit name=\"noted\"><notify/></permit>"),
            PolicyFacts.none(),
            requests,
            log,
            InstantSource.fixed(NOON),
            nanos::get);
    for (int i = 0; i < 5; i++) {
      assertThat(guard.decide(call(ANNA, "emergencyStop")).isPermitted()).isTrue();
    }
    assertThat(waiting).as("written by another thread").hasSize(2);
    assertThat(log.countLine()).as("those that were not taken").isEqualTo(3);
  }
}
