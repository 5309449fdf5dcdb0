package org.dfra.river.discovery;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import net.jini.core.lookup.ServiceID;
import org.dfra.river.discovery.AnnouncedHosts.Place;
import org.dfra.river.fixture.SteppedTime;
import org.junit.jupiter.api.Test;

/** Whom a search asks, where anybody may announce anything. */
class AnnouncedHostsTest {

  private static final Place HONEST = new Place("192.0.2.1", 4160);
  private static final ServiceID ID = new ServiceID(0, 1);
  private static final FakeRegistrar REGISTRAR = new FakeRegistrar(1, "field");

  private final SteppedTime time = new SteppedTime();
  private final AnnouncedHosts hosts = new AnnouncedHosts(time::nanos);
  private int rogues;

  /** A place that was never announced before, on a host of its own. */
  private Place rogue(boolean isDirect) {
    int number = ++rogues;
    Place place = new Place("198.51." + number / 250 + "." + number % 250, 4160);
    hosts.announced(place, new ServiceID(1, number), isDirect);
    return place;
  }

  private List<Place> allNext() {
    List<Place> asked = new ArrayList<>();
    for (Optional<Place> next = hosts.next(0); next.isPresent(); next = hosts.next(0)) {
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
      Place unused = rogue(i % 2 == 0);
    }
    assertThat(hosts.size()).isEqualTo(AnnouncedHosts.REMEMBERED);
  }

  @Test
  void keepsTheLastProbeForPlacesThatAnsweredBefore() throws Exception {
    LocatedRegistrar registrar = know();
    for (int i = 0; i < 100; i++) {
      Place unused = rogue(true);
    }
    assertThat(allNext()).hasSize(AnnouncedHosts.PROBES - 1).doesNotContain(HONEST);
    hosts.lost(registrar);
    time.pass(AnnouncedHosts.SHORTEST_WAIT);
    assertThat(allNext()).containsExactly(HONEST);
    assertThat(hosts.next(0)).isEmpty();
  }

  @Test
  void asksPlacesThatAnsweredBeforeFirstThenThoseAnnouncedFromTheirOwnAddress() throws Exception {
    LocatedRegistrar registrar = know();
    Place elsewhere = rogue(false);
    Place direct = rogue(true);
    hosts.lost(registrar);
    time.pass(AnnouncedHosts.SHORTEST_WAIT);
    hosts.announced(HONEST, ID, true); // the latest of them, so its age does not put it first
    assertThat(allNext()).containsExactly(HONEST, direct, elsewhere);
  }

  @Test
  void aPlaceAnnouncedFromItsOwnAddressIsNotForgottenForOthers() {
    hosts.announced(HONEST, ID, true);
    for (int i = 0; i < 1000; i++) {
      Place unused = rogue(false);
    }
    assertThat(hosts.next(0)).contains(HONEST);
  }

  @Test
  void whatFailedIsForgottenBeforeWhatWasNotAskedYet() {
    for (int i = 0; i < AnnouncedHosts.REMEMBERED - 1; i++) {
      Place unused = rogue(true);
    }
    List<Place> asked = allNext();
    asked.forEach(hosts::failed);
    hosts.announced(HONEST, ID, true);
    for (int i = 0; i < asked.size(); i++) {
      Place unused = rogue(true);
    }
    List<Place> later = new ArrayList<>();
    for (int i = 0; i < AnnouncedHosts.REMEMBERED; i++) {
      List<Place> some = allNext();
      some.forEach(hosts::failed);
      later.addAll(some);
    }
    assertThat(later).contains(HONEST).doesNotContainAnyElementsOf(asked);
  }

  @Test
  void asksAHostAtOneOfItsPlacesAtATimeAndRemembersFew() {
    for (int port = 1; port <= 100; port++) {
      hosts.announced(new Place("203.0.113.66", port), new ServiceID(2, port), true);
    }
    assertThat(hosts.size()).isEqualTo(AnnouncedHosts.PER_HOST);
    hosts.announced(HONEST, ID, true);
    List<Place> asked = allNext();
    assertThat(asked).hasSize(2).contains(HONEST);
  }

  @Test
  void waitsLongerAfterEachFailureAndForgets() throws Exception {
    LocatedRegistrar unused = know();
    Place rogue = rogue(true);
    for (int failures = 0; failures < AnnouncedHosts.FAILURES; failures++) {
      assertThat(hosts.next(0)).as("after %d failures", failures).contains(rogue);
      hosts.failed(rogue);
      hosts.announced(HONEST, ID, true); // whatever else is announced changes nothing
      assertThat(hosts.next(0)).isEmpty();
      if (failures < AnnouncedHosts.FAILURES - 1) {
        Duration wait = AnnouncedHosts.SHORTEST_WAIT.multipliedBy(1L << failures);
        assertThat(hosts.untilNext()).contains(wait.toNanos());
        time.pass(wait);
      }
    }
    assertThat(hosts.size()).as("the honest one is left").isEqualTo(1);
    assertThat(hosts.untilNext()).isEmpty();
  }

  @Test
  void anAnnouncementDoesNotShortenTheWaitOfAPlaceThatNeverAnswered() {
    Place rogue = rogue(true);
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
      time.pass(AnnouncedHosts.LONGEST_WAIT);
      assertThat(hosts.next(0)).contains(HONEST);
      hosts.failed(HONEST);
    }
    hosts.announced(HONEST, ID, true);
    time.pass(AnnouncedHosts.SHORTEST_WAIT);
    assertThat(hosts.next(0)).contains(HONEST);
  }

  @Test
  void aCopyOfAServiceIdHidesNoOtherPlace() throws Exception {
    Place rogue = rogue(true);
    assertThat(hosts.next(0)).contains(rogue);
    hosts.succeeded(rogue, new FakeRegistrar(1, "a copy").at(rogue.host(), rogue.port()));
    hosts.announced(HONEST, ID, true);
    assertThat(allNext()).containsExactly(HONEST);
  }

  @Test
  void aLookupServiceThatMovedIsAskedWhereItIsNow() throws Exception {
    LocatedRegistrar registrar = know();
    Place moved = new Place("192.0.2.2", 4160);
    hosts.announced(moved, ID, true);
    assertThat(hosts.next(0)).as("nobody is there yet").contains(moved);
    hosts.failed(moved);
    hosts.lost(registrar);
    time.pass(AnnouncedHosts.SHORTEST_WAIT);
    assertThat(allNext()).containsExactlyInAnyOrder(HONEST, moved);
  }

  @Test
  void onePlaceThatIsLostLosesNoOtherThatIsHeld() throws Exception {
    LocatedRegistrar registrar = know();
    Place second = new Place("192.0.2.2", 4160);
    hosts.announced(second, ID, true);
    assertThat(hosts.next(0)).contains(second);
    hosts.succeeded(second, new FakeRegistrar(1, "a copy").at(second.host(), second.port()));
    hosts.lost(registrar);
    time.pass(AnnouncedHosts.SHORTEST_WAIT);
    assertThat(allNext()).containsExactly(HONEST);
  }

  @Test
  void whatWasPostponedIsAskedLaterAndHasNotFailed() {
    Place rogue = rogue(true);
    for (int i = 0; i < 2 * AnnouncedHosts.FAILURES; i++) {
      assertThat(hosts.next(0)).contains(rogue);
      hosts.postponed(rogue);
      assertThat(hosts.next(0)).isEmpty();
      assertThat(hosts.untilNext()).contains(AnnouncedHosts.SHORTEST_WAIT.toNanos());
      time.pass(AnnouncedHosts.SHORTEST_WAIT);
    }
  }
}
