package org.dfra.river.discovery;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import net.jini.core.lookup.ServiceID;
import org.dfra.river.discovery.DiscoveryCandidates.LookupAddress;
import org.dfra.river.fixture.SteppedTime;
import org.junit.jupiter.api.Test;

/** Whom a search asks, where anybody may announce anything. */
class DiscoveryCandidatesTest {

  private static final LookupAddress HONEST = new LookupAddress("192.0.2.1", 4160);
  private static final ServiceID ID = new ServiceID(0, 1);
  private static final FakeRegistrar REGISTRAR = new FakeRegistrar(1, "field");

  private final SteppedTime time = new SteppedTime();
  private final DiscoveryCandidates hosts = new DiscoveryCandidates(time::nanos);
  private int rogues;

  /** A place that was never announced before, on a host of its own. */
  private LookupAddress rogue(boolean isDirect) {
    int number = ++rogues;
    LookupAddress place = new LookupAddress("198.51." + number / 250 + "." + number % 250, 4160);
    hosts.announced(place, new ServiceID(1, number), isDirect);
    return place;
  }

  private List<LookupAddress> allNext() {
    List<LookupAddress> asked = new ArrayList<>();
    for (Optional<LookupAddress> next = hosts.next(0); next.isPresent(); next = hosts.next(0)) {
      asked.add(next.get());
    }
    return asked;
  }

  /** The honest lookup service has answered, and is held. */
  private LocatedRegistrar know() throws IOException {
    hosts.announced(HONEST, ID, true);
    assertThat(hosts.next(0)).contains(HONEST);
    LocatedRegistrar registrar = REGISTRAR.at(HONEST.host(), HONEST.port());
    hosts.succeeded(HONEST, registrar);
    return registrar;
  }

  @Test
  void remembersNoMoreThanItMay() {
    for (int i = 0; i < 1000; i++) {
      LookupAddress unused = rogue(i % 2 == 0);
    }
    assertThat(hosts.size()).isEqualTo(DiscoveryCandidates.MAX_CANDIDATES);
  }

  @Test
  void keepsTheLastProbeForPlacesThatAnsweredBefore() throws Exception {
    LocatedRegistrar registrar = know();
    for (int i = 0; i < 100; i++) {
      LookupAddress unused = rogue(true);
    }
    assertThat(allNext()).hasSize(DiscoveryCandidates.PROBES - 1).doesNotContain(HONEST);
    hosts.lost(registrar);
    time.pass(DiscoveryCandidates.SHORTEST_WAIT);
    assertThat(allNext()).containsExactly(HONEST);
    assertThat(hosts.next(0)).isEmpty();
  }

  @Test
  void asksPlacesThatAnsweredBeforeFirstThenThoseAnnouncedFromTheirOwnAddress() throws Exception {
    LocatedRegistrar registrar = know();
    LookupAddress elsewhere = rogue(false);
    LookupAddress direct = rogue(true);
    hosts.lost(registrar);
    time.pass(DiscoveryCandidates.SHORTEST_WAIT);
    hosts.announced(HONEST, ID, true); // the latest of them, so its age does not put it first
    assertThat(allNext()).containsExactly(HONEST, direct, elsewhere);
  }

  @Test
  void aPlaceAnnouncedFromItsOwnAddressIsNotForgottenForOthers() {
    hosts.announced(HONEST, ID, true);
    for (int i = 0; i < 1000; i++) {
      LookupAddress unused = rogue(false);
    }
    assertThat(hosts.next(0)).contains(HONEST);
  }

  @Test
  void whatFailedIsForgottenBeforeWhatWasNotAskedYet() {
    for (int i = 0; i < DiscoveryCandidates.MAX_CANDIDATES - 1; i++) {
      LookupAddress unused = rogue(true);
    }
    List<LookupAddress> asked = allNext();
    asked.forEach(hosts::failed);
    hosts.announced(HONEST, ID, true);
    for (int i = 0; i < asked.size(); i++) {
      LookupAddress unused = rogue(true);
    }
    List<LookupAddress> later = new ArrayList<>();
    for (int i = 0; i < DiscoveryCandidates.MAX_CANDIDATES; i++) {
      List<LookupAddress> some = allNext();
      some.forEach(hosts::failed);
      later.addAll(some);
    }
    assertThat(later).contains(HONEST).doesNotContainAnyElementsOf(asked);
  }

  @Test
  void asksAHostAtOneOfItsPlacesAtATimeAndRemembersFew() {
    for (int port = 1; port <= 100; port++) {
      hosts.announced(new LookupAddress("203.0.113.66", port), new ServiceID(2, port), true);
    }
    assertThat(hosts.size()).isEqualTo(DiscoveryCandidates.PER_HOST);
    hosts.announced(HONEST, ID, true);
    List<LookupAddress> asked = allNext();
    assertThat(asked).hasSize(2).contains(HONEST);
  }

  @Test
  void waitsLongerAfterEachFailureAndForgets() throws Exception {
    LocatedRegistrar unused = know();
    LookupAddress rogue = rogue(true);
    for (int failures = 0; failures < DiscoveryCandidates.FAILURES; failures++) {
      assertThat(hosts.next(0)).as("after %d failures", failures).contains(rogue);
      hosts.failed(rogue);
      hosts.announced(HONEST, ID, true); // whatever else is announced changes nothing
      assertThat(hosts.next(0)).isEmpty();
      if (failures < DiscoveryCandidates.FAILURES - 1) {
        Duration wait = DiscoveryCandidates.SHORTEST_WAIT.multipliedBy(1L << failures);
        assertThat(hosts.untilNext()).contains(wait.toNanos());
        time.pass(wait);
      }
    }
    assertThat(hosts.size()).as("the honest one is left").isEqualTo(1);
    assertThat(hosts.untilNext()).isEmpty();
  }

  @Test
  void anAnnouncementDoesNotShortenTheWaitOfAPlaceThatNeverAnswered() {
    LookupAddress rogue = rogue(true);
    assertThat(hosts.next(0)).contains(rogue);
    hosts.failed(rogue);
    hosts.announced(rogue, new ServiceID(3, 3), true);
    assertThat(hosts.next(0)).isEmpty();
  }

  @Test
  void aPlaceThatAnsweredBeforeIsAskedSoonAfterItIsAnnouncedAgain() throws Exception {
    LocatedRegistrar registrar = know();
    hosts.lost(registrar);
    for (int i = 0; i < 8; i++) {
      time.pass(DiscoveryCandidates.LONGEST_WAIT);
      assertThat(hosts.next(0)).contains(HONEST);
      hosts.failed(HONEST);
    }
    hosts.announced(HONEST, ID, true);
    time.pass(DiscoveryCandidates.SHORTEST_WAIT);
    assertThat(hosts.next(0)).contains(HONEST);
  }

  @Test
  void aCopyOfAServiceIdHidesNoOtherPlace() throws Exception {
    LookupAddress rogue = rogue(true);
    assertThat(hosts.next(0)).contains(rogue);
    hosts.succeeded(rogue, new FakeRegistrar(1, "a copy").at(rogue.host(), rogue.port()));
    hosts.announced(HONEST, ID, true);
    assertThat(allNext()).containsExactly(HONEST);
  }

  @Test
  void aLookupServiceThatMovedIsAskedWhereItIsNow() throws Exception {
    LocatedRegistrar registrar = know();
    LookupAddress moved = new LookupAddress("192.0.2.2", 4160);
    hosts.announced(moved, ID, true);
    assertThat(hosts.next(0)).as("nobody is there yet").contains(moved);
    hosts.failed(moved);
    hosts.lost(registrar);
    time.pass(DiscoveryCandidates.SHORTEST_WAIT);
    assertThat(allNext()).containsExactlyInAnyOrder(HONEST, moved);
  }

  @Test
  void onePlaceThatIsLostLosesNoOtherThatIsHeld() throws Exception {
    LocatedRegistrar registrar = know();
    LookupAddress second = new LookupAddress("192.0.2.2", 4160);
    hosts.announced(second, ID, true);
    assertThat(hosts.next(0)).contains(second);
    hosts.succeeded(second, new FakeRegistrar(1, "a copy").at(second.host(), second.port()));
    hosts.lost(registrar);
    time.pass(DiscoveryCandidates.SHORTEST_WAIT);
    assertThat(allNext()).containsExactly(HONEST);
  }

  @Test
  void whatWasPostponedIsAskedLaterAndHasNotFailed() {
    LookupAddress rogue = rogue(true);
    for (int i = 0; i < 2 * DiscoveryCandidates.FAILURES; i++) {
      assertThat(hosts.next(0)).contains(rogue);
      hosts.postponed(rogue);
      assertThat(hosts.next(0)).isEmpty();
      assertThat(hosts.untilNext()).contains(DiscoveryCandidates.SHORTEST_WAIT.toNanos());
      time.pass(DiscoveryCandidates.SHORTEST_WAIT);
    }
  }
}
