package org.dfra.core.lease;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.util.ArrayList;
import java.util.List;
import java.util.UUID;
import org.dfra.core.lease.LeaseBook.Holder;
import org.dfra.lease.LeaseRefusedException;
import org.junit.jupiter.api.Test;

class LeaseBookTest {

  private final SteppedScheduler time = new SteppedScheduler();
  private final List<Integer> told = new ArrayList<>();
  private final List<String> over = new ArrayList<>();
  private final LeaseBook book =
      new LeaseBook(
          "atrv1/gps", LeaseTerms.USUAL, InstantSource.fixed(Instant.EPOCH), time, told::add);

  @Test
  void tellsTheFirstClientAndTheLast() throws Exception {
    Grant first = book.grant(Duration.ofSeconds(10), Holder.CLIENT, () -> over.add("first"));
    Grant second = book.grant(Duration.ofSeconds(20), Holder.CLIENT, () -> over.add("second"));
    assertThat(first.expiration()).isEqualTo(Instant.EPOCH.plusSeconds(10));
    assertThat(book.cancel(second.id())).isTrue();
    assertThat(book.cancel(second.id())).isFalse();
    time.step(Duration.ofSeconds(10));
    assertThat(told).containsExactly(1, 2, 1, 0);
    assertThat(over).as("a lease that was given back is not over").containsExactly("first");
    assertThat(book.renew(first.id(), Duration.ofSeconds(1))).isEmpty();
  }

  @Test
  void endsALeaseExactlyWhenItsTimeIsUp() throws Exception {
    Grant grant = book.grant(Duration.ofSeconds(10), Holder.CLIENT, () -> over.add("it"));
    time.step(Duration.ofSeconds(9));
    assertThat(book.renew(grant.id(), Duration.ofSeconds(5))).isPresent();
    time.step(Duration.ofSeconds(5).minusNanos(1));
    assertThat(book.clients()).isEqualTo(1);
    time.step(Duration.ofNanos(1));
    assertThat(book.clients()).isZero();
    assertThat(time.waiting()).isZero();
  }

  @Test
  void watchersAreNoClients() throws Exception {
    Grant watching = book.grant(Duration.ofSeconds(5), Holder.WATCHER, () -> over.add("watcher"));
    assertThat(book.clients()).isZero();
    assertThat(book.holds(watching.id())).isTrue();
    time.step(Duration.ofSeconds(5));
    assertThat(over).containsExactly("watcher");
    assertThat(told).isEmpty();
  }

  @Test
  void whoLivesWithTheModuleNeedNotRenew() throws Exception {
    UUID held = book.hold(Holder.CLIENT, () -> over.add("held"));
    time.step(Duration.ofDays(1));
    assertThat(book.holds(held)).isTrue();
    book.close();
    assertThat(over).containsExactly("held");
    assertThat(told).containsExactly(1, 0);
    assertThatThrownBy(() -> book.hold(Holder.CLIENT, () -> {}))
        .isInstanceOf(LeaseRefusedException.class)
        .hasMessage("atrv1/gps grants no leases any more; it has ended");
  }

  @Test
  void refusesTermsThatCannotBeKept() {
    assertThatThrownBy(() -> new LeaseTerms(Duration.ofSeconds(1), Duration.ofSeconds(2)))
        .hasMessage("usual lease 2 s is outside 0.001 s to the longest 1 s");
    assertThatThrownBy(() -> book.grant(Duration.ofMillis(30_001), Holder.CLIENT, () -> {}))
        .hasMessage("atrv1/gps: lease 30.001 s > longest allowed 30 s; ask for 30 s or less");
    assertThatThrownBy(() -> book.grant(Duration.ofMillis(Long.MAX_VALUE), Holder.CLIENT, () -> {}))
        .hasMessage("atrv1/gps: lease for ever > longest allowed 30 s; ask for 30 s or less");
  }
}
