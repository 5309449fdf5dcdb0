package org.dfra.river.server;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicLong;
import org.dfra.core.budget.Budget;
import org.dfra.core.budget.BudgetGuard;
import org.dfra.core.budget.BudgetLimits;
import org.dfra.core.budget.Budgets;
import org.dfra.core.budget.ListenerShare;
import org.dfra.core.config.SourceLocation;
import org.dfra.event.Delivery;
import org.dfra.event.ModuleEvent;
import org.dfra.event.ModuleEvent.ReadinessChanged;
import org.dfra.event.Reading;
import org.dfra.lifecycle.Readiness;
import org.dfra.security.Caller;
import org.dfra.security.Caller.Standing;
import org.dfra.security.Decision;
import org.dfra.security.Member;
import org.dfra.security.MemberRole;
import org.junit.jupiter.api.Test;

/** A listener gets fewer readings, and all other events. */
class BudgetedListenerTest {

  private static final Caller OTTO =
      new Caller(
          Standing.MEMBER,
          Optional.of(new Member("field", MemberRole.OBSERVER, "otto")),
          "192.0.2.8");
  private static final int BYTES = 1000;

  private final AtomicLong nanos = new AtomicLong();
  private final List<Delivery> received = new ArrayList<>();
  private final AtomicLong notSent = new AtomicLong();
  private final BudgetLimits limits =
      new BudgetLimits(
          BYTES, BudgetLimits.UNLIMITED, BudgetLimits.UNLIMITED, BudgetLimits.UNLIMITED);
  private final Budgets budgets =
      new Budgets(
          List.of(
              new Budget(
                  "bytes",
                  caller -> true,
                  robot -> true,
                  object -> true,
                  Budget.Scope.CALLER,
                  limits,
                  false,
                  new SourceLocation("policy.xml", 1))),
          List.of());
  private final BudgetGuard guard =
      new BudgetGuard(
          request -> Decision.permit("any"),
          () -> budgets,
          "atrv1",
          request -> false,
          nanos::get,
          wait -> {});
  private int oneIn = 1;
  private long sequence;

  private record Temperature(double celsius) implements Reading {
    @Override
    public Instant measured() {
      return Instant.EPOCH;
    }
  }

  private BudgetedListener listener(ListenerShare share) {
    return new BudgetedListener(
        received::addAll, share, () -> oneIn, notSent::addAndGet, nanos::get);
  }

  private Delivery delivery(ModuleEvent event) {
    return new Delivery("atrv1/gps", 1, sequence++, 0, Instant.EPOCH, event);
  }

  private Delivery reading() {
    return delivery(new ModuleEvent.NewReading(new Temperature(sequence)));
  }

  /** Readings of a second, in calls of five. */
  private void second(BudgetedListener listener, int readings) throws Exception {
    for (int i = 0; i < readings; i += 5) {
      nanos.addAndGet(TimeUnit.SECONDS.toNanos(1) * 5 / readings);
      listener.notify(List.of(reading(), reading(), reading(), reading(), reading()));
    }
  }

  private void assertNothingIsUnaccounted() {
    long counted = received.stream().mapToLong(each -> 1 + each.dropped()).sum();
    long last = received.get(received.size() - 1).sequence();
    assertThat(counted).as("received and dropped up to the last one").isEqualTo(last + 1);
  }

  @Test
  void getsEveryReadingUntilTheRadioIsFullAndThenEveryNth() throws Exception {
    BudgetedListener listener = listener(guard.admitListener(OTTO, "gps"));
    second(listener, 100);
    assertThat(received).hasSize(100);
    oneIn = 4;
    second(listener, 100);
    assertThat(received.size()).isBetween(124, 126);
    oneIn = 1;
    second(listener, 100);
    assertThat(received.size()).isBetween(224, 226);
    assertNothingIsUnaccounted();
    assertThat(notSent.get()).isBetween(74L, 76L);
  }

  @Test
  void getsOneReadingInASecondHoweverFullTheRadioIs() throws Exception {
    BudgetedListener listener = listener(guard.admitListener(OTTO, "gps"));
    oneIn = 64;
    for (int i = 0; i < 30; i++) {
      second(listener, 5);
    }
    assertThat(received.size()).isBetween(29, 33);
    assertNothingIsUnaccounted();
  }

  @Test
  void losesNoChangeOfReadiness() throws Exception {
    BudgetedListener listener = listener(guard.admitListener(OTTO, "gps"));
    ListenerShare share = guard.admitListener(OTTO, "gps");
    oneIn = 64;
    share.count(20 * BYTES, 0); // the budget of bytes is used up too
    int changes = 0;
    for (int i = 0; i < 200; i++) {
      nanos.addAndGet(TimeUnit.MILLISECONDS.toNanos(1));
      Readiness to = i % 2 == 0 ? Readiness.ACTIVE : Readiness.READY;
      listener.notify(
          List.of(reading(), delivery(new ReadinessChanged(Readiness.READY, to)), reading()));
      changes++;
    }
    assertThat(received)
        .filteredOn(each -> each.event() instanceof ReadinessChanged)
        .hasSize(changes);
    assertThat(received.size()).isLessThan(changes + 10);
    assertNothingIsUnaccounted();
  }

  @Test
  void getsOneReadingInASecondWhileItsBytesAreUsedUp() throws Exception {
    ListenerShare share = guard.admitListener(OTTO, "gps");
    BudgetedListener listener = listener(share);
    second(listener, 50);
    assertThat(received).hasSize(50);
    share.count(4 * BYTES, 0);
    second(listener, 50);
    second(listener, 50);
    assertThat(received.size()).isBetween(51, 53);
    nanos.addAndGet(TimeUnit.SECONDS.toNanos(2));
    second(listener, 50);
    assertThat(received.size()).isBetween(101, 103);
    assertNothingIsUnaccounted();
    assertThat(guard.use().get(0).thinned()).isBetween(97L, 99L);
  }
}
