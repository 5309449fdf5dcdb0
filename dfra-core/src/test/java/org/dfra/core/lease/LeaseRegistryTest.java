package org.dfra.core.lease;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.util.ArrayList;
import java.util.List;
import java.util.UUID;
import java.util.concurrent.atomic.AtomicReference;
import org.dfra.core.lease.LeaseRegistry.LeaseGrant;
import org.dfra.lease.LeaseHandle;
import org.dfra.lease.LeaseRefusedException;
import org.dfra.lease.LeaseRole;
import org.dfra.lease.LeaseStatus;
import org.junit.jupiter.api.Test;

class LeaseRegistryTest {

  private final SteppedScheduler time = new SteppedScheduler();
  private final List<Integer> reported = new ArrayList<>();
  private final List<String> over = new ArrayList<>();
  private final LeaseRegistry book =
      new LeaseRegistry(
          "atrv1/gps", LeaseTerms.DEFAULT, InstantSource.fixed(Instant.EPOCH), time, reported::add);

  @Test
  void reportsTheFirstClientAndTheLast() throws Exception {
    LeaseGrant first =
        book.grant(Duration.ofSeconds(10), LeaseRole.CLIENT, null, () -> over.add("first"));
    LeaseGrant second =
        book.grant(Duration.ofSeconds(20), LeaseRole.CLIENT, null, () -> over.add("second"));
    assertThat(first.expiration()).isEqualTo(Instant.EPOCH.plusSeconds(10));
    assertThat(book.cancel(second.id())).isTrue();
    assertThat(book.cancel(second.id())).isFalse();
    time.step(Duration.ofSeconds(10));
    assertThat(reported).containsExactly(1, 2, 1, 0);
    assertThat(over).as("a lease that was given back is not over").containsExactly("first");
    assertThat(book.renew(first.id(), Duration.ofSeconds(1))).isEmpty();
  }

  @Test
  void endsALeaseExactlyWhenItsTimeIsUp() throws Exception {
    LeaseGrant grant =
        book.grant(Duration.ofSeconds(10), LeaseRole.CLIENT, null, () -> over.add("it"));
    time.step(Duration.ofSeconds(9));
    assertThat(book.renew(grant.id(), Duration.ofSeconds(5))).isPresent();
    time.step(Duration.ofSeconds(5).minusNanos(1));
    assertThat(book.clients()).isEqualTo(1);
    time.step(Duration.ofNanos(1));
    assertThat(book.clients()).isZero();
    assertThat(time.waiting()).isZero();
  }

  @Test
  void aProlongedLeaseEndsTheDefaultDurationAfterTheLastProofThatItsHolderLives() throws Exception {
    LeaseGrant grant =
        book.grant(Duration.ofSeconds(10), LeaseRole.CLIENT, null, () -> over.add("it"));
    for (int i = 0; i < 5; i++) {
      time.step(Duration.ofSeconds(6));
      assertThat(book.prolong(grant.id())).isTrue();
    }
    assertThat(time.waiting()).as("timers of one lease").isEqualTo(1);
    assertThat(book.leases().get(0).remaining()).isEqualTo(Duration.ofSeconds(10));
    time.step(Duration.ofSeconds(10).minusNanos(1));
    assertThat(book.contains(grant.id())).isTrue();
    time.step(Duration.ofNanos(1));
    assertThat(over).containsExactly("it");
    assertThat(book.prolong(grant.id())).as("a lease that has ended").isFalse();
    assertThat(time.waiting()).isZero();
  }

  @Test
  void prolongingShortensNoLeaseAndWakesNoneThatWasRevoked() throws Exception {
    LeaseGrant grant =
        book.grant(Duration.ofSeconds(30), LeaseRole.CLIENT, null, () -> over.add("it"));
    assertThat(book.prolong(grant.id())).isTrue();
    time.step(Duration.ofSeconds(29));
    assertThat(over).isEmpty();
    assertThat(book.prolong(grant.id())).isTrue();
    assertThat(book.renew(grant.id(), Duration.ofSeconds(20))).isPresent();
    time.step(Duration.ofSeconds(19));
    assertThat(book.contains(grant.id())).isTrue();
    assertThat(book.revoke(grant.id())).isTrue();
    assertThat(book.prolong(grant.id())).isFalse();
    assertThat(over).containsExactly("it");
  }

  @Test
  void watchersAreNoClients() throws Exception {
    LeaseGrant watching =
        book.grant(Duration.ofSeconds(5), LeaseRole.OBSERVER, null, () -> over.add("watcher"));
    assertThat(book.clients()).isZero();
    assertThat(book.contains(watching.id())).isTrue();
    time.step(Duration.ofSeconds(5));
    assertThat(over).containsExactly("watcher");
    assertThat(reported).isEmpty();
  }

  @Test
  void aClientInTheSameProcessNeedNotRenew() throws Exception {
    UUID held = book.grantLocal(LeaseRole.CLIENT, () -> over.add("held"));
    time.step(Duration.ofDays(1));
    assertThat(book.contains(held)).isTrue();
    book.close();
    assertThat(over).containsExactly("held");
    assertThat(reported).containsExactly(1, 0);
    assertThatThrownBy(() -> book.grantLocal(LeaseRole.CLIENT, () -> {}))
        .isInstanceOf(LeaseRefusedException.class)
        .hasMessage("atrv1/gps grants no leases any more; it has ended");
  }

  @Test
  void listsWhoHoldsWhat() throws Exception {
    LeaseGrant far = book.grant(Duration.ofSeconds(10), LeaseRole.OBSERVER, "192.0.2.7", () -> {});
    UUID near = book.grantLocal(LeaseRole.CLIENT, () -> {});
    time.step(Duration.ofSeconds(4));
    assertThat(book.leases())
        .containsExactlyInAnyOrder(
            new LeaseStatus(
                LeaseHandle.of(far.id()),
                LeaseRole.OBSERVER,
                "192.0.2.7",
                Instant.EPOCH,
                Duration.ofSeconds(4),
                Duration.ofSeconds(6)),
            new LeaseStatus(
                LeaseHandle.of(near),
                LeaseRole.CLIENT,
                null,
                Instant.EPOCH,
                Duration.ofSeconds(4),
                null));
    assertThat(book.cancel(near)).isTrue();
    time.step(Duration.ofSeconds(6));
    assertThat(book.leases()).isEmpty();
  }

  @Test
  void theOldestIsListedFirstWhateverIsDoneToTheClock() throws Exception {
    AtomicReference<Instant> wall = new AtomicReference<>(Instant.EPOCH);
    try (LeaseRegistry stepped =
        new LeaseRegistry("atrv1/gps", LeaseTerms.DEFAULT, wall::get, time, clients -> {})) {
      UUID older = stepped.grantLocal(LeaseRole.CLIENT, () -> {});
      time.step(Duration.ofSeconds(4));
      wall.set(Instant.EPOCH.minus(Duration.ofHours(1)));
      UUID younger = stepped.grantLocal(LeaseRole.CLIENT, () -> {});
      time.step(Duration.ofSeconds(1));
      assertThat(stepped.leases())
          .extracting(LeaseStatus::handle)
          .containsExactly(LeaseHandle.of(older), LeaseHandle.of(younger));
      assertThat(stepped.leases())
          .extracting(LeaseStatus::age)
          .containsExactly(Duration.ofSeconds(5), Duration.ofSeconds(1));
    }
  }

  @Test
  void whatIsListedRevokesALeaseButNeitherRenewsNorCancelsIt() throws Exception {
    LeaseGrant grant =
        book.grant(Duration.ofSeconds(10), LeaseRole.CLIENT, null, () -> over.add("it"));
    LeaseHandle listed = book.leases().get(0).handle();
    assertThat(listed).isEqualTo(LeaseHandle.of(grant.id()));
    assertThat(listed.value()).isNotEqualTo(grant.id());
    assertThat(book.renew(listed.value(), Duration.ofSeconds(1))).isEmpty();
    assertThat(book.cancel(listed.value())).isFalse();
    assertThat(book.revoke(listed.value())).as("taken for the secret").isFalse();
    assertThat(over).isEmpty();
    assertThat(book.revoke(listed)).isTrue();
    assertThat(book.revoke(listed)).as("a second time").isFalse();
    assertThat(over).containsExactly("it");
    assertThat(book.isRevoked(grant.id())).isTrue();
  }

  @Test
  void aRevokedLeaseIsOverAndKnownAsRevokedWhileItsHolderMayAsk() throws Exception {
    LeaseGrant grant =
        book.grant(Duration.ofSeconds(10), LeaseRole.CLIENT, "192.0.2.7", () -> over.add("it"));
    UUID held = book.grantLocal(LeaseRole.CLIENT, () -> over.add("held"));
    assertThat(book.revoke(grant.id())).isTrue();
    assertThat(book.revoke(grant.id())).as("a second time").isFalse();
    assertThat(book.revoke(held)).isTrue();
    assertThat(over).containsExactly("it", "held");
    assertThat(reported).containsExactly(1, 2, 1, 0);
    assertThat(book.renew(grant.id(), Duration.ofSeconds(1))).isEmpty();
    assertThat(book.isRevoked(grant.id())).isTrue();
    assertThat(book.isRevoked(held)).as("nobody renews it").isFalse();
    time.step(LeaseTerms.DEFAULT.maxDuration());
    assertThat(book.isRevoked(grant.id())).isFalse();
    assertThat(time.waiting()).isZero();
  }

  @Test
  void distinguishesAnEndFromALeaseThatIsGivenBack() throws Exception {
    LeaseGrant given =
        book.grant(
            Duration.ofSeconds(10),
            LeaseRole.COMMANDER,
            null,
            () -> over.add("given over"),
            () -> over.add("given cancelled"));
    UUID held =
        book.grantLocal(
            LeaseRole.COMMANDER, () -> over.add("held over"), () -> over.add("held cancelled"));
    assertThat(book.cancel(given.id())).isTrue();
    assertThat(book.cancel(given.id())).isFalse();
    time.step(Duration.ofSeconds(10));
    assertThat(book.cancel(held)).isTrue();
    book.close();
    assertThat(over).containsExactly("given cancelled", "held cancelled");
    assertThat(reported).as("a commander is a client").containsExactly(1, 2, 1, 0);
  }

  @Test
  void anEndIsReportedOnceWhicheverComesFirst() throws Exception {
    Runnable cancelled = () -> over.add("cancelled");
    LeaseGrant expired =
        book.grant(
            Duration.ofSeconds(1), LeaseRole.COMMANDER, null, () -> over.add("expired"), cancelled);
    time.step(Duration.ofSeconds(1));
    UUID revoked = book.grantLocal(LeaseRole.COMMANDER, () -> over.add("revoked"), cancelled);
    assertThat(book.revoke(revoked)).isTrue();
    UUID closed = book.grantLocal(LeaseRole.COMMANDER, () -> over.add("closed"), cancelled);
    book.close();
    assertThat(book.cancel(expired.id()) || book.cancel(revoked) || book.cancel(closed)).isFalse();
    assertThat(over).containsExactly("expired", "revoked", "closed");
  }

  @Test
  void aCallbackThatFailsDoesNotPreventThoseOfOtherLeases() throws Exception {
    IllegalStateException deaf = new IllegalStateException("deaf");
    for (int i = 0; i < 3; i++) {
      UUID unused =
          book.grantLocal(
              LeaseRole.CLIENT,
              () -> {
                over.add("one");
                throw deaf;
              });
    }
    assertThatThrownBy(book::close).isSameAs(deaf);
    assertThat(over).containsExactly("one", "one", "one");
    assertThat(reported).containsExactly(1, 2, 3, 0);
  }

  @Test
  void anEndIsReportedEvenWhereTheCountIsNot() throws Exception {
    LeaseRegistry broken =
        new LeaseRegistry(
            "atrv1/gps",
            LeaseTerms.DEFAULT,
            InstantSource.fixed(Instant.EPOCH),
            time,
            clients -> {
              if (clients == 0) {
                throw new IllegalStateException("cannot count to zero");
              }
            });
    UUID held = broken.grantLocal(LeaseRole.COMMANDER, () -> {}, () -> over.add("cancelled"));
    assertThatThrownBy(() -> broken.cancel(held)).hasMessage("cannot count to zero");
    assertThat(over).containsExactly("cancelled");
  }

  @Test
  void refusesTermsThatCannotBeKept() {
    assertThatThrownBy(() -> new LeaseTerms(Duration.ofSeconds(1), Duration.ofSeconds(2)))
        .hasMessage("usual lease 2 s is outside 0.001 s to the longest 1 s");
    assertThatThrownBy(
            () -> book.grant(Duration.ofMillis(30_001), LeaseRole.CLIENT, null, () -> {}))
        .hasMessage("atrv1/gps: lease 30.001 s > longest allowed 30 s; ask for 30 s or less");
    assertThatThrownBy(
            () -> book.grant(Duration.ofMillis(Long.MAX_VALUE), LeaseRole.CLIENT, null, () -> {}))
        .hasMessage("atrv1/gps: lease for ever > longest allowed 30 s; ask for 30 s or less");
  }

  @Test
  void aLeaseThatIsRevokedInTheBackgroundEndsOnTheExecutorOfItsRole() throws Exception {
    List<Runnable> submitted = new ArrayList<>();
    LeaseRegistry registry =
        new LeaseRegistry(
            "atrv1/gps",
            LeaseTerms.DEFAULT,
            InstantSource.fixed(Instant.EPOCH),
            time,
            reported::add,
            role -> role == LeaseRole.COMMANDER ? submitted::add : Runnable::run);
    LeaseGrant commander =
        registry.grant(Duration.ofSeconds(10), LeaseRole.COMMANDER, null, () -> over.add("it"));
    registry.revokeInBackground(commander.id());
    assertThat(over).as("on the thread that brought the news").isEmpty();
    assertThat(submitted).hasSize(1);
    submitted.get(0).run();
    assertThat(over).containsExactly("it");
    assertThat(registry.isRevoked(commander.id())).isTrue();
    registry.revokeInBackground(commander.id());
    assertThat(submitted).as("for a lease that is over").hasSize(1);
  }

  @Test
  void aLeaseThatExpiresAtOnceIsNotRememberedAsRevoked() throws Exception {
    LeaseGrant grant =
        book.grant(Duration.ofSeconds(10), LeaseRole.CLIENT, null, () -> over.add("it"));
    book.expireInBackground(grant.id());
    assertThat(over).containsExactly("it");
    assertThat(book.contains(grant.id())).isFalse();
    assertThat(book.isRevoked(grant.id())).as("its holder may ask for another").isFalse();
    assertThat(time.waiting()).isZero();
    assertThat(reported).containsExactly(1, 0);
  }
}
