package org.dfra.river.contract;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;
import static org.awaitility.Awaitility.await;

import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.Set;
import org.assertj.core.api.ThrowableAssert.ThrowingCallable;
import org.dfra.event.Delivery;
import org.dfra.event.DeliveryPolicy;
import org.dfra.event.DeliveryPolicy.EventKind;
import org.dfra.event.ModuleEvent;
import org.dfra.event.Subscription;
import org.dfra.flow.sensor.GPSSensor;
import org.dfra.lease.LeaseRefusedException;
import org.dfra.lease.ModuleLease;
import org.dfra.lifecycle.Incident;
import org.dfra.lifecycle.Readiness;
import org.dfra.module.Diagnosis;
import org.dfra.module.LogLevel;
import org.dfra.module.ModuleHistory;
import org.dfra.module.Parameter;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** What every module guarantees to its clients, wherever it runs. */
@Timeout(60)
abstract class ModuleContract {

  /** An overloaded machine may take its time. */
  static final Duration PATIENCE = Duration.ofSeconds(20);

  static final String PATH = "atrv1/gps_front";

  /** The module, as its client holds it. */
  abstract GPSSensor module();

  /** Its driver, which the test controls. */
  abstract ScriptedGps driver();

  private static final DeliveryPolicy READINGS =
      DeliveryPolicy.keepLast(100).withKinds(EventKind.READING);
  private static final DeliveryPolicy OTHERS =
      DeliveryPolicy.keepLast(100)
          .withKinds(EventKind.READINESS, EventKind.PARAMETER, EventKind.INCIDENT);

  @Test
  void saysWhoItIsAndServes() throws Exception {
    assertThat(module().identification().path()).isEqualTo(PATH);
    assertThat(module().awaitReadiness(PATIENCE)).isEqualTo(Readiness.READY);
    assertThat(module().fix().position()).isEqualTo(driver().fix().position());
  }

  @Test
  void publishesReadingsInOrderAndNumbersThemWithoutGap() throws Exception {
    RecordingListener listener = new RecordingListener();
    try (Subscription subscription = module().subscribe(listener, READINGS)) {
      for (int i = 0; i < 50; i++) {
        driver().solve(i);
        driver().stumble(); // another kind, which this listener does not want
      }
      List<Delivery> received = listener.await(50);
      assertThat(listener.latitudes()).isSorted().hasSize(50);
      for (int i = 1; i < received.size(); i++) {
        assertThat(received.get(i).sequence()).isEqualTo(received.get(i - 1).sequence() + 1);
      }
      assertThat(received).allMatch(each -> each.module().equals(PATH) && each.epoch() == 1);
      assertThat(subscription.received()).isEqualTo(50);
      assertThat(subscription.lost()).isZero();
      assertThat(subscription.interruptedSince()).isEmpty();
    }
  }

  @Test
  void publishesReadinessParametersAndIncidents() throws Exception {
    RecordingListener listener = new RecordingListener();
    try (Subscription unused = module().subscribe(listener, OTHERS)) {
      driver().lose();
      module().setParameter("rate", "5");
      listener.await(3);
      assertThat(listener.received())
          .extracting(Delivery::event)
          .containsExactly(
              new ModuleEvent.ReadinessChanged(Readiness.READY, Readiness.INITIALIZING),
              new ModuleEvent.IncidentRecorded(last(module().history())),
              new ModuleEvent.ParameterChanged("rate", "5"));
    }
  }

  private static Incident last(ModuleHistory history) {
    return history.recent().get(history.recent().size() - 1);
  }

  @Test
  void aSlowListenerKeepsTheNewestAndLearnsHowManyItMissed() throws Exception {
    RecordingListener listener = new RecordingListener();
    listener.stop();
    try (Subscription subscription =
        module()
            .subscribe(
                listener,
                new DeliveryPolicy(Set.of(EventKind.READING), 3, Double.POSITIVE_INFINITY))) {
      driver().solve(0);
      listener.await(1);
      for (int i = 1; i <= 20; i++) {
        driver().solve(i);
      }
      driver().solve(21);
      listener.open();
      await().atMost(PATIENCE).until(() -> listener.latitudes().contains(21.0));
      long dropped = listener.received().stream().mapToLong(Delivery::dropped).sum();
      assertThat(subscription.lost()).isPositive().isEqualTo(dropped);
      assertThat(subscription.received() + subscription.lost()).isEqualTo(22);
      assertThat(listener.latitudes()).isSorted();
    }
  }

  @Test
  void aListenerIsNotifiedNoMoreOftenThanItWants() throws Exception {
    RecordingListener listener = new RecordingListener();
    long began = System.nanoTime();
    try (Subscription subscription =
        module().subscribe(listener, new DeliveryPolicy(Set.of(EventKind.READING), 1, 20))) {
      for (int i = 0; i < 100; i++) {
        driver().solve(i * 0.5);
      }
      await().atMost(PATIENCE).until(() -> listener.latitudes().contains(49.5));
      double seconds = (System.nanoTime() - began) / 1e9;
      assertThat((double) listener.received().size()).isLessThanOrEqualTo(1 + seconds * 20);
      assertThat(subscription.received() + subscription.lost()).isEqualTo(100);
    }
  }

  @Test
  void aListenerThatThrowsIsNotifiedOfTheNextEventAllTheSame() throws Exception {
    RecordingListener listener = new RecordingListener();
    listener.throwing = true;
    try (Subscription unused = module().subscribe(listener, READINGS)) {
      for (int i = 0; i < 5; i++) {
        driver().solve(i);
      }
      listener.await(5);
      assertThat(listener.latitudes()).containsExactly(0.0, 1.0, 2.0, 3.0, 4.0);
    }
  }

  @Test
  void aClosedSubscriptionReceivesNothing() throws Exception {
    RecordingListener listener = new RecordingListener();
    RecordingListener other = new RecordingListener();
    Subscription closed = module().subscribe(listener, READINGS);
    closed.close();
    closed.close();
    await().atMost(PATIENCE).until(() -> driver().leases().clients() == 0);
    try (Subscription unused = module().subscribe(other, READINGS)) {
      driver().solve(1);
      other.await(1);
    }
    assertThat(listener.received()).isEmpty();
  }

  @Test
  void aListenerToReadingsIsAClientAndOneToOtherEventsOnlyWatches() throws Exception {
    try (Subscription watching = module().subscribe(new RecordingListener(), OTHERS)) {
      assertThat(module().readiness()).isEqualTo(Readiness.READY);
      try (Subscription listening = module().subscribe(new RecordingListener(), READINGS)) {
        await().atMost(PATIENCE).until(() -> module().readiness() == Readiness.ACTIVE);
        assertThat(driver().clients).isEqualTo(1);
      }
      await().atMost(PATIENCE).until(() -> module().readiness() == Readiness.READY);
      assertThat(driver().clients).isZero();
    }
  }

  @Test
  void isActiveWhileItHasClients() throws Exception {
    Instant asked = Instant.now();
    ModuleLease first = module().acquireLease(Duration.ofSeconds(30));
    assertThat(first.expiration())
        .isBetween(asked.plusSeconds(28), Instant.now().plusSeconds(32)); // 30, within 2
    ModuleLease second = module().acquireLease(Duration.ofSeconds(20));
    assertThat(first.isLive()).isTrue();
    assertThat(module().readiness()).isEqualTo(Readiness.ACTIVE);
    assertThat(driver().clients).isEqualTo(2);
    driver().lose();
    driver().find();
    assertThat(module().readiness()).as("found again, with clients").isEqualTo(Readiness.ACTIVE);
    first.close();
    first.close();
    second.close();
    await().atMost(PATIENCE).until(() -> module().readiness() == Readiness.READY);
    assertThat(first.isLive()).isFalse();
    assertThat(driver().clients).isZero();
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "PT120S | lease 120 s > longest allowed 30 s; ask for 30 s or less",
        "PT0S | lease 0 s is not above 0; ask for 30 s or less",
        "PT-1S | lease -1 s is not above 0; ask for 30 s or less"
      })
  void refusesALeaseItDoesNotGrant(Duration asked, String sentence) {
    assertThatThrownBy(() -> module().acquireLease(asked))
        .isInstanceOf(LeaseRefusedException.class)
        .hasMessage(PATH + ": " + sentence);
    assertThat(driver().leases().clients()).isZero();
  }

  @Test
  void remembersWhatHappenedToIt() throws Exception {
    driver().lose();
    driver().find();
    driver().stumble();
    ModuleHistory history = module().history();
    assertThat(history.activations()).isEqualTo(1);
    assertThat(history.failures()).isEqualTo(1);
    assertThat(history.exceptions()).isEqualTo(1);
    assertThat(history.servingTime()).isPositive();
    assertThat(history.meanTimeBetweenFailures()).isPresent();
    assertThat(history.recent())
        .extracting(Incident::kind)
        .containsExactly(
            Incident.Kind.ACTIVATION,
            Incident.Kind.FAILURE,
            Incident.Kind.RECOVERY,
            Incident.Kind.EXCEPTION);
    assertThat(history.recent().get(1).description()).isEqualTo("its cable was cut");
  }

  @Test
  void showsItsParametersAndTakesNewOnes() throws Exception {
    assertThat(module().parameters())
        .extracting(Parameter::name)
        .isSorted()
        .contains("mount_x", "rate", "serial");
    module().setParameter("rate", "4");
    assertThat(module().updateRate()).isEqualTo(0.25);
    assertThat(module().parameters())
        .contains(
            new Parameter("rate", "4", "between positions, a whole number from 1 to 255 s", true))
        .contains(new Parameter("serial", "42", "its serial number", false));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "ratte | 1 | has no parameter \"ratte\"; did you mean \"rate\"?",
        "rate | 0 | parameter rate cannot be \"0\", which is not a whole number from 1 to 255 s",
        "rate | 1.5 | parameter rate cannot be \"1.5\", which is not a whole number",
        "rate | fast | parameter rate cannot be \"fast\", which is not a whole number",
        "serial | 7 | parameter serial cannot be set while it runs; write it in the robot's XML",
        "mount_frame | '' | parameter mount_frame cannot be \"\", which is not the name of a frame",
      })
  void refusesParametersItCannotTake(String name, String text, String sentence) {
    assertRefused(() -> module().setParameter(name, text), sentence);
  }

  @Test
  void runsItsTestsHoweverLongTheyLast() throws Exception {
    assertThat(module().preconditions())
        .singleElement()
        .hasToString(driver().preconditions().get(0).toString());
    assertThat(module().tests()).containsExactly("quick", "slow", "broken");
    assertThat(module().test("quick")).matches(Diagnosis::passed, "passed");
    Diagnosis slow = module().test("slow");
    assertThat(slow.passed()).isFalse();
    assertThat(slow.finding()).isEqualTo("it was slow");
    assertThat(slow.duration()).isGreaterThan(Duration.ofSeconds(2));
    assertThat(module().test("broken").finding())
        .isEqualTo("it could not be done: java.lang.IllegalStateException: no such wire");
  }

  @Test
  void runsItsRecoveries() throws Exception {
    assertThat(module().recoveries()).containsExactly("kick");
    assertThat(module().recover("kick").finding()).isEqualTo("it runs again");
    assertThat(module().history().failures()).isEqualTo(1);
    assertThat(module().readiness()).isEqualTo(Readiness.READY);
  }

  @Test
  void refusesExaminationsItDoesNotKnow() {
    assertRefused(() -> module().test("quik"), "knows no test \"quik\"; did you mean \"quick\"?");
    assertRefused(
        () -> module().recover("prayer"), "knows no recovery method \"prayer\"; it knows kick");
  }

  @Test
  void setsItsLogLevelWhileItRuns() throws Exception {
    module().setLogLevel(LogLevel.DEBUG);
    assertThat(module().logLevel()).isEqualTo(LogLevel.DEBUG);
    module().setLogLevel(LogLevel.INFO);
    assertThat(module().logLevel()).isEqualTo(LogLevel.INFO);
  }

  @Test
  void standsWhereItIsMounted() throws Exception {
    assertThat(module().frame()).isEqualTo(PATH);
    assertThat(module().parentFrame()).isEqualTo("atrv1/base_link");
    assertThat(module().localTransform().x()).isZero();
    module().setParameter("mount_frame", "atrv1/mast");
    module().setParameter("mount_x", "0.25");
    module().setParameter("mount_yaw", "1.5");
    assertThat(module().parentFrame()).isEqualTo("atrv1/mast");
    assertThat(module().localTransform().x()).isEqualTo(0.25);
    assertThat(module().localTransform().yaw()).isCloseTo(1.5, within(1e-12));
  }

  @Test
  void isWiredAndRewired() throws Exception {
    assertThat(module().inputTypes()).isEmpty();
    assertThat(module().outputTypes()).containsExactly("GpsFix");
    module().setOutputs(List.of("atrv1/pose", "atrv1/log"));
    module().setOutputs(List.of("atrv1/pose"));
    assertThat(module().outputs()).containsExactly("atrv1/pose");
    assertThat(module().inputs()).isEmpty();
    assertRefused(
        () -> module().setInputs(List.of("atrv1/laser")),
        "takes no input; give it none, but was given 1");
    assertRefused(
        () -> module().setOutputs(List.of("pose")),
        "cannot be wired to \"pose\", which is not the path of a module; write robot/name");
    assertRefused(() -> module().setOutputs(List.of(PATH)), "cannot be wired to itself");
    assertThat(module().outputs()).as("after the refusals").containsExactly("atrv1/pose");
  }

  private static void assertRefused(ThrowingCallable call, String sentence) {
    assertThatThrownBy(call)
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageStartingWith(PATH)
        .hasMessageContaining(sentence);
  }
}
