package org.dfra.directory;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.tuple;
import static org.awaitility.Awaitility.await;
import static org.dfra.directory.Condition.atLeast;
import static org.dfra.directory.Condition.contains;
import static org.dfra.directory.Condition.equalTo;

import java.rmi.ConnectException;
import java.rmi.UnmarshalException;
import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import org.dfra.flow.sensor.GPSSensor;
import org.dfra.flow.sensor.LocationSensor;
import org.dfra.geometry.GeoPosition;
import org.dfra.lifecycle.Readiness;
import org.dfra.module.Module;
import org.dfra.module.NotReadyException;
import org.dfra.persona.GpsReceiverAttributes;
import org.dfra.persona.LocationAttributes;
import org.dfra.persona.ModuleAttributes;
import org.dfra.persona.PersonaAttributes;
import org.dfra.persona.SensorAttributes;
import org.junit.jupiter.api.Test;

/** What every directory does. */
abstract class DirectoryContract extends DirectoryFixture {

  private List<String> names(ModuleQuery<?> query) {
    return directory.find(query).stream().map(ModuleListing::name).toList();
  }

  @Test
  void findsByInterfaceRobotNameAndAttributes() throws Exception {
    list("a", "slow", 1);
    list("a", "fast", 10);
    list("b", "fast", 5);
    GpsReceiverAttributes device =
        new GpsReceiverAttributes("M12+", null, null, null, 12, List.of("2D", "3D"));
    list("device", and(attributes("b", "device", 2), device), Locality.SAME_HOST);
    ModuleQuery<LocationSensor> any = ModuleQuery.of(LocationSensor.class);

    assertThat(names(any)).hasSize(4);
    assertThat(names(any.robot("a"))).containsExactly("fast", "slow");
    assertThat(names(any.robot("a").name("fast"))).containsExactly("fast");
    assertThat(names(any.where(SensorAttributes.class, "maxRate", atLeast(5))))
        .containsExactly("fast", "fast");
    assertThat(names(any.where(GpsReceiverAttributes.class, "fixModes", contains("3D"))))
        .containsExactly("device");
    assertThat(names(any.where(GpsReceiverAttributes.class, "serialNumber", contains("P"))))
        .as("an unknown value meets no condition")
        .isEmpty();
    assertThat(names(any.where(ModuleAttributes.class, "state", equalTo(Readiness.PAUSED))))
        .isEmpty();
    ModuleListing<LocationSensor> listing = directory.find(any.name("device")).get(0);
    assertThat(listing.attributes(GpsReceiverAttributes.class)).contains(device);
    assertThat(listing.stale()).isFalse();
    assertThat(listing.staleness(Instant.now())).isZero();
  }

  @Test
  void findsWhatIsNearAlsoByItsRobotsLocation() throws Exception {
    GeoPosition here = new GeoPosition(52.9103, 6.8667, 50);
    GeoPosition near = new GeoPosition(52.9105, 6.8667, 90); // 22 m north
    list(
        "gps",
        and(attributes("near", "gps", 1), new LocationAttributes(near, Instant.EPOCH)),
        Locality.SAME_HOST);
    list("near", "laser", 1);
    list("nowhere", "laser", 1);
    ModuleQuery<GPSSensor> any = ModuleQuery.of(GPSSensor.class);
    assertThat(names(any.within(50, here))).containsExactly("gps", "laser");
    assertThat(names(any.within(10, here))).isEmpty();
  }

  @Test
  void prefersTheNearestAndThoseThatWork() throws Exception {
    list("e", and(List.of(module("r", "e", "192.0.2.1", Readiness.READY))), Locality.REMOTE);
    list("d", and(List.of(module("r", "d", "127.0.0.1", Readiness.FAILED))), Locality.SAME_VM);
    list("c", and(List.of(module("r", "c", "127.0.0.1", Readiness.READY))), Locality.SAME_HOST);
    list("b", and(List.of(module("r", "b", "127.0.0.1", Readiness.READY))), Locality.SAME_VM);
    list("a", and(List.of(module("r", "a", "127.0.0.1", Readiness.READY))), Locality.SAME_HOST);
    List<ModuleListing<Module>> found = directory.find(ModuleQuery.of(Module.class));
    assertThat(found).extracting(ModuleListing::name).containsExactly("b", "a", "c", "e", "d");
    assertThat(found)
        .extracting(ModuleListing::locality)
        .containsExactly(
            Locality.SAME_VM,
            Locality.SAME_HOST,
            Locality.SAME_HOST,
            Locality.REMOTE,
            Locality.SAME_VM);
  }

  @Test
  void waitsForAModuleAsLongAsGivenAndNotLonger() throws Exception {
    ModuleQuery<GPSSensor> query = ModuleQuery.of(GPSSensor.class).name("late");
    assertThat(directory.findFirst(query, Duration.ofMillis(50))).isEmpty();
    CompletableFuture<Optional<ModuleListing<GPSSensor>>> waiting =
        CompletableFuture.supplyAsync(
            () -> {
              try {
                return directory.findFirst(query, PATIENCE);
              } catch (InterruptedException e) {
                throw new IllegalStateException(e);
              }
            });
    list("r", "late", 1);
    assertThat(waiting.get(10, TimeUnit.SECONDS)).isPresent();
  }

  @Test
  void notifiesListenersOfMatchChangeAndNoMatch() throws Exception {
    list("r", "before", 10);
    RecordingDirectoryListener received = new RecordingDirectoryListener();
    try (DirectoryRegistration watch =
        directory.listen(
            ModuleQuery.of(GPSSensor.class).where(SensorAttributes.class, "maxRate", atLeast(5)),
            received)) {
      assertThat(received.next()).isEqualTo("matched before");
      list("r", "slow", 1);
      ListedGps gps = list("r", "gps", 5);
      assertThat(received.next()).isEqualTo("matched gps");
      fixture.announce(gps, attributes("r", "gps", 6), Locality.SAME_HOST);
      assertThat(received.next()).isEqualTo("changed gps");
      fixture.announce(gps, attributes("r", "gps", 4), Locality.SAME_HOST);
      assertThat(received.next()).isEqualTo("unmatched gps");
      fixture.announce(gps, attributes("r", "gps", 7), Locality.SAME_HOST);
      assertThat(received.next()).isEqualTo("matched gps");
      fixture.withdraw(gps.id());
      assertThat(received.next()).isEqualTo("unmatched gps");
      fixture.loseSight();
      assertThat(received.next()).as("%s", watch).isEqualTo("changed before stale");
    }
    assertThat(received.lines).isEmpty();
  }

  @Test
  void aSlowListenerDelaysNoOtherAndReceivesTheLastState() throws Exception {
    CountDownLatch blocked = new CountDownLatch(1);
    CountDownLatch go = new CountDownLatch(1);
    BlockingQueue<Double> rates = new LinkedBlockingQueue<>();
    ModuleQuery<GPSSensor> query = ModuleQuery.of(GPSSensor.class);
    RecordingDirectoryListener healthy = new RecordingDirectoryListener();
    try (DirectoryRegistration slow =
            directory.listen(
                query,
                new DirectoryListener<>() {
                  @Override
                  public void matched(ModuleListing<GPSSensor> listing) {
                    blocked.countDown();
                    try {
                      go.await();
                    } catch (InterruptedException e) {
                      Thread.currentThread().interrupt();
                    }
                  }

                  @Override
                  public void changed(
                      ModuleListing<GPSSensor> before, ModuleListing<GPSSensor> now) {
                    rates.add(now.attributes(SensorAttributes.class).orElseThrow().maxRate());
                  }
                });
        DirectoryRegistration other = directory.listen(query, healthy)) {
      ListedGps gps = list("r", "gps", 1);
      assertThat(blocked.await(10, TimeUnit.SECONDS)).as("%s %s", slow, other).isTrue();
      assertThat(healthy.next()).isEqualTo("matched gps");
      for (int rate = 2; rate <= 9; rate++) {
        fixture.announce(gps, attributes("r", "gps", rate), Locality.SAME_HOST);
        assertThat(healthy.next()).isEqualTo("changed gps");
      }
      go.countDown();
      assertThat(rates.poll(10, TimeUnit.SECONDS))
          .as("eight changes, reported as one")
          .isEqualTo(9);
      assertThat(rates).isEmpty();
    }
  }

  @Test
  void aListenerThatFailsIsNotifiedOfTheNextAllTheSame() throws Exception {
    RecordingDirectoryListener received =
        new RecordingDirectoryListener() {
          @Override
          public void matched(ModuleListing<GPSSensor> listing) {
            super.matched(listing);
            throw new IllegalStateException("on purpose");
          }
        };
    try (DirectoryRegistration watch =
        directory.listen(ModuleQuery.of(GPSSensor.class), received)) {
      list("r", "one", 1);
      list("r", "two", 1);
      assertThat(received.next()).as("%s", watch).isEqualTo("matched one");
      assertThat(received.next()).isEqualTo("matched two");
    }
  }

  @Test
  void keepsTheLastKnownAsStaleWithItsAge() throws Exception {
    list("r", "gps", 1);
    fixture.announce(new PersonaAttributes("r", "scout", List.of("map"), List.of()));
    await().atMost(PATIENCE).until(() -> directory.personas().get(0).attributes().isPresent());
    fixture.loseSight();
    await()
        .atMost(PATIENCE)
        .until(() -> directory.find(ModuleQuery.of(GPSSensor.class)).get(0).stale());
    ModuleListing<GPSSensor> kept = directory.find(ModuleQuery.of(GPSSensor.class)).get(0);
    assertThat(kept.module().identification().name()).isEqualTo("gps");
    assertThat(kept.staleness(kept.confirmed().plusSeconds(7))).isEqualTo(Duration.ofSeconds(7));
    assertThat(kept.confirmed()).isBetween(Instant.now().minusSeconds(20), Instant.now());
    await().atMost(PATIENCE).until(() -> directory.personas().get(0).stale());
    assertThat(directory.personas()).hasSize(1);
  }

  @Test
  void listsRobotsWithTheirModules() throws Exception {
    list("b", "gps", 1);
    list("a", "laser", 1);
    list("a", "gps", 1);
    PersonaAttributes persona =
        new PersonaAttributes("a", "scout", List.of("map the field"), List.of("no stairs"));
    fixture.announce(persona);
    fixture.announce(new PersonaAttributes("c", "", List.of(), List.of()));
    await().atMost(PATIENCE).until(() -> directory.personas().size() == 3);
    await().atMost(PATIENCE).until(() -> directory.personas().get(0).attributes().isPresent());
    List<Persona> personas = directory.personas();
    assertThat(personas).extracting(Persona::robot).containsExactly("a", "b", "c");
    assertThat(personas.get(0).attributes()).contains(persona);
    assertThat(personas.get(0).modules())
        .extracting(ModuleListing::name)
        .containsExactly("gps", "laser");
    assertThat(personas.get(1).attributes()).isEmpty();
    assertThat(personas.get(2).modules()).isEmpty();
    assertThat(personas).noneMatch(Persona::stale);
  }

  private void listElsewhere(String robot, String name) throws Exception {
    list(name, List.of(module(robot, name, "192.0.2.1", Readiness.READY)), Locality.REMOTE);
  }

  @Test
  void robotsOfOneNameOnTwoHostsAreTwo() throws Exception {
    list("a", "gps", 1);
    list("a", "laser", 1);
    listElsewhere("a", "gps");
    PersonaAttributes persona = new PersonaAttributes("a", "scout", List.of("map"), List.of());
    await()
        .atMost(PATIENCE)
        .untilAsserted(
            () ->
                assertThat(directory.personas())
                    .extracting(Persona::robot, Persona::host, each -> each.modules().size())
                    .containsExactly(tuple("a", "127.0.0.1", 2), tuple("a", "192.0.2.1", 1)));
    fixture.announce(persona);
    fixture.announce(new PersonaAttributes("b", "carrier", List.of(), List.of()));
    await()
        .atMost(PATIENCE)
        .until(() -> directory.personas().stream().anyMatch(each -> each.robot().equals("b")));
    assertThat(directory.personas())
        .as("whose persona it is, is not known")
        .extracting(Persona::robot, Persona::host, each -> each.attributes().isPresent())
        .containsExactly(
            tuple("a", "127.0.0.1", false), tuple("a", "192.0.2.1", false), tuple("b", "", true));
  }

  @Test
  void aModuleIsNotNearWhereARobotOfTheSameNameIs() throws Exception {
    GeoPosition here = new GeoPosition(52.9103, 6.8667, 50);
    list(
        "gps",
        and(attributes("r", "gps", 1), new LocationAttributes(here, Instant.EPOCH)),
        Locality.SAME_HOST);
    listElsewhere("r", "laser");
    assertThat(names(ModuleQuery.of(GPSSensor.class).within(50, here))).containsExactly("gps");
  }

  @Test
  void aProxyForAQueryAsksAnotherModuleWhenAQuestionFails() throws Exception {
    ListedGps one = list("r", "one", 1);
    ListedGps two = list("r", "two", 1);
    Lamp lamp = directory.proxyFor(ModuleQuery.of(Lamp.class));
    assertThat(lamp.who()).isEqualTo("one");
    one.behaviour().failure = new UnmarshalException("on purpose");
    assertThat(lamp.who()).isEqualTo("two");
    assertThat(one.behaviour().calls).hasValue(2);
    assertThat(lamp.who()).isEqualTo("two");
    assertThat(one.behaviour().calls).as("one that failed is left alone").hasValue(2);
    two.behaviour().failure = new ConnectException("on purpose too");
    assertThatThrownBy(lamp::who).as("once more, not for ever").isInstanceOf(Exception.class);
    assertThat(one.behaviour().calls).hasValue(3);
    assertThat(two.behaviour().calls).hasValue(3);
  }

  @Test
  void aProxyForAQueryAsksAnotherModuleWhereOneIsNotReady() throws Exception {
    ListedGps one = list("r", "one", 1);
    ListedGps two = list("r", "two", 1);
    Lamp lamp = directory.proxyFor(ModuleQuery.of(Lamp.class));
    one.behaviour().notReady = new NotReadyException("r/one", Readiness.INITIALIZING, "on purpose");
    assertThat(lamp.who()).isEqualTo("two");
    assertThat(lamp.who()).isEqualTo("two");
    assertThat(one.behaviour().calls).as("one that was not ready is left alone").hasValue(1);
    two.behaviour().notReady = new NotReadyException("r/two", Readiness.INITIALIZING, "too");
    assertThatThrownBy(lamp::who).as("once more, not for ever").hasMessageContaining("r/one");
    assertThatThrownBy(lamp::toggle)
        .as("a command goes to one only")
        .isInstanceOf(NotReadyException.class)
        .hasNoSuppressedExceptions();
  }

  @Test
  void aProxyForAQueryNeverRepeatsACommandAndSaysWhetherItMayHaveRun() throws Exception {
    ListedGps one = list("r", "one", 1);
    ListedGps two = list("r", "two", 1);
    Lamp lamp = directory.proxyFor(ModuleQuery.of(Lamp.class));
    one.behaviour().failure = new UnmarshalException("on purpose");
    assertThatThrownBy(lamp::toggle)
        .isInstanceOf(CallFailedException.class)
        .hasMessageStartingWith(
            "toggle on r/one failed; it may have run, so repeat it only if repeating does no harm");
    assertThat(two.behaviour().calls).hasValue(0);
    two.behaviour().failure = new ConnectException("on purpose");
    assertThatThrownBy(lamp::toggle)
        .as("the next command goes to the other")
        .hasMessageStartingWith("toggle on r/two failed; it has not run");
    assertThat(one.behaviour().calls).hasValue(1);
  }

  @Test
  void aProxyForAQueryFollowsTheDirectory() throws Exception {
    Lamp lamp = directory.proxyFor(ModuleQuery.of(Lamp.class).robot("r").name("x"));
    assertThatThrownBy(lamp::who)
        .isInstanceOf(NoModuleFoundException.class)
        .hasMessage("there is no Lamp named x on r now; start one, or ask for less");
    ListedGps x = list("r", "x", 1);
    assertThat(lamp.who()).isEqualTo("x");
    assertThat(lamp).isEqualTo(lamp).hasToString("any Lamp named x on r");
    fixture.withdraw(x.id());
    await()
        .atMost(PATIENCE)
        .untilAsserted(
            () -> assertThatThrownBy(lamp::who).isInstanceOf(NoModuleFoundException.class));
  }

  @Test
  void answersFiftyQuestionsAsASearchOfEverythingDoes() throws Exception {
    ScriptedQuestions script =
        new ScriptedQuestions(Boolean.getBoolean("dfra.full") ? 10_000 : 1_000);
    for (ScriptedQuestions.Listed each : script.listed()) {
      fixture.announce(each.module(), each.attributes(), Locality.SAME_HOST);
    }
    ModuleQuery<GPSSensor> all = ModuleQuery.of(GPSSensor.class);
    await()
        .atMost(Duration.ofSeconds(120))
        .until(() -> directory.find(all).size() == script.listed().size());
    assertThat(script.questions()).hasSize(50);
    for (ScriptedQuestions.Question question : script.questions()) {
      assertThat(directory.find(question.query()).stream().map(ModuleListing::id).toList())
          .as("%s", question.query())
          .containsExactlyInAnyOrderElementsOf(script.answer(question));
    }
    assertThat(script.questions()).anyMatch(question -> script.answer(question).size() > 10);
  }
}
