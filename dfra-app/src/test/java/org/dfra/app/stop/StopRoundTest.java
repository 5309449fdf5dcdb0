package org.dfra.app.stop;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.tuple;

import java.rmi.ConnectException;
import java.rmi.RemoteException;
import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.UUID;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import org.dfra.app.stop.Outcome.Result;
import org.dfra.app.stop.PhoenixAddresses.Address;
import org.dfra.flow.effector.StopState;
import org.dfra.river.phoenix.stop.EffectorStop;
import org.dfra.river.phoenix.stop.StopReport;
import org.dfra.river.phoenix.stop.UnconfirmedGroup;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

@Timeout(60)
class StopRoundTest {

  private static final Instant NOON = Instant.parse("2026-11-21T12:00:00Z");
  private static final UUID REGISTRAR = UUID.randomUUID();
  private static final Address ROBOT = new Address("192.0.2.7", 1198);
  private static final Duration RUNNING = Duration.ofSeconds(2);
  private static final StopState STOPPED = stopped(Duration.ofSeconds(1), true, null);

  private final BlockingQueue<Outcome> well = new LinkedBlockingQueue<>();
  private final CountDownLatch end = new CountDownLatch(1);
  private final StopMerge merge = new StopMerge("the test", () -> RUNNING);
  private final StopRound round =
      new StopRound(Result.NOT_STOPPED, Duration.ofSeconds(20), well::add, merge);

  @BeforeEach
  void findRegistrar() {
    round.registrarAt(REGISTRAR, ROBOT.host());
  }

  @AfterEach
  void close() {
    end.countDown();
    round.close();
  }

  private static Outcome stopped(String path) {
    return Outcome.ofStop(path, RUNNING, STOPPED);
  }

  private static StopState stopped(Duration age, boolean resting, @Nullable String fault) {
    return new StopState(true, "ops", NOON, resting, fault, age);
  }

  @Test
  void oneThatIsSilentHoldsUpNoOther() throws Exception {
    for (int i = 0; i < 50; i++) {
      round.callListed(UUID.randomUUID(), REGISTRAR, "mute/drive" + i, this::beSilent);
    }
    round.callListed(UUID.randomUUID(), REGISTRAR, "atrv1/drive", () -> stopped("atrv1/drive"));
    assertThat(well.poll(20, TimeUnit.SECONDS)).isEqualTo(stopped("atrv1/drive"));
  }

  /** Under other names than an honest effector's, and under that of its robot. */
  @ParameterizedTest
  @ValueSource(strings = {"fake%s/drive", "atrv1/fake%s"})
  void fiveHundredThatAreSilentHoldUpNoOther(String path) throws Exception {
    for (int i = 0; i < 500; i++) {
      round.callListed(UUID.randomUUID(), REGISTRAR, path.formatted(i), this::beSilent);
    }
    round.callListed(UUID.randomUUID(), REGISTRAR, "atrv1/drive", () -> stopped("atrv1/drive"));
    assertThat(well.poll(15, TimeUnit.SECONDS)) // less than the patience, which is 20 s
        .isEqualTo(stopped("atrv1/drive"));
  }

  @Test
  void theWordOfAProxyIsPublishedWhenItIsKnownWhichPhoenixItsComputerHas() throws Exception {
    UUID elsewhere = UUID.randomUUID();
    round.callListed(UUID.randomUUID(), elsewhere, "theta/drive", () -> stopped("theta/drive"));
    round.callListed(UUID.randomUUID(), REGISTRAR, "atrv1/drive", () -> stopped("atrv1/drive"));
    assertThat(well.poll(20, TimeUnit.SECONDS)).isEqualTo(stopped("atrv1/drive"));
    round.askPhoenix(
        new Address("192.0.2.9", 1198),
        false,
        () -> new StopReport(List.of("theta"), List.of(), List.of()));
    round.registrarAt(elsewhere, "192.0.2.9");
    assertThat(round.outcomes())
        .extracting(Outcome::module, Outcome::result)
        .containsExactlyInAnyOrder(
            tuple("theta/drive", Result.DOUBTFUL), tuple("atrv1/drive", Result.STOPPED));
    assertThat(well).isEmpty();
  }

  @Test
  void aPhoenixThatOnlyDiscoveryNamedConfirmsOnlyWhatItsLookupServiceLists() {
    UUID own = UUID.randomUUID();
    UUID another = UUID.randomUUID();
    round.askPhoenix(
        ROBOT,
        false,
        () -> report(List.of("atrv1"), confirmed(own, "atrv1/drive"), confirmed(another, "x/y")));
    round.callListed(own, REGISTRAR, "atrv1/drive", () -> stopped("atrv1/drive"));
    assertThat(round.outcomes())
        .extracting(Outcome::module, Outcome::result)
        .containsExactlyInAnyOrder(
            tuple("atrv1/drive", Result.STOPPED), tuple("x/y", Result.DOUBTFUL));
    assertThat(well).as("it is not published before everything is known").isEmpty();
  }

  @Test
  void aNameThatIsOfThisComputerIsNotSilent() {
    round.askPhoenix(new Address("this-computer", 1198), false, () -> null);
    round.callListed(UUID.randomUUID(), REGISTRAR, "atrv1/drive", () -> stopped("atrv1/drive"));
    assertThat(round.outcomes()).containsExactly(stopped("atrv1/drive"));
  }

  private Outcome beSilent() throws InterruptedException {
    end.await();
    return stopped("too late");
  }

  @Test
  void whatIsNotAnsweredInTimeIsTriedOnceMoreAndTold() {
    AtomicInteger calls = new AtomicInteger();
    try (StopRound brief =
        new StopRound(Result.NOT_STOPPED, Duration.ofMillis(50), well::add, merge)) {
      brief.callListed(
          UUID.randomUUID(),
          REGISTRAR,
          "mute/drive",
          () -> {
            calls.incrementAndGet();
            return beSilent();
          });
      assertThat(brief.outcomes())
          .containsExactly(
              new Outcome(
                  "mute/drive",
                  Result.NOT_STOPPED,
                  null,
                  null,
                  "it did not answer within 0.05 s, twice"));
    }
    assertThat(calls.get()).isLessThanOrEqualTo(2); // a busy machine may begin a try too late
    assertThat(well).isEmpty();
  }

  @Test
  void whatFailsOnceIsTriedOnceMore() {
    AtomicInteger calls = new AtomicInteger();
    UUID id = UUID.randomUUID();
    for (int i = 0; i < 3; i++) { // it is listed by three lookup services
      round.callListed(
          id,
          REGISTRAR,
          "atrv1/drive",
          () -> {
            if (calls.incrementAndGet() == 1) {
              throw new ConnectException("refused\nnested exception is: so and so");
            }
            return stopped("atrv1/drive");
          });
    }
    assertThat(round.outcomes()).containsExactly(stopped("atrv1/drive"));
    assertThat(calls).hasValue(2);
  }

  @Test
  void aStrangersProxyUnderItsIdentityTakesNoEffectorsPlace() {
    UUID id = UUID.randomUUID();
    AtomicInteger calls = new AtomicInteger();
    round.callListed(
        id,
        UUID.randomUUID(),
        "atrv1/drive",
        () -> {
          throw new ConnectException("it is a stranger's");
        });
    round.callListed(
        id,
        UUID.randomUUID(),
        "atrv1/drive",
        () -> {
          calls.incrementAndGet();
          return stopped("atrv1/drive");
        });
    assertThat(round.outcomes())
        .as("one of both is the effector, and which is not known")
        .extracting(Outcome::module, Outcome::result)
        .containsExactly(tuple("atrv1/drive", Result.NOT_STOPPED));
    assertThat(calls).hasValue(1);
  }

  @Test
  void whatFailsTwiceIsToldInOneLine() {
    round.callListed(
        UUID.randomUUID(),
        REGISTRAR,
        "atrv1/drive",
        () -> {
          throw new ConnectException("refused\nnested exception is: so and so");
        });
    assertThat(round.outcomes())
        .singleElement()
        .returns(Result.NOT_STOPPED, Outcome::result)
        .returns("atrv1/drive: NOT STOPPED: refused.", Outcome::inWords);
  }

  @Test
  void itsOwnHostReachesWhatNoLookupServiceDoes() {
    round.callListed(
        UUID.randomUUID(),
        REGISTRAR,
        "atrv1/drive",
        () -> {
          throw new ConnectException("refused");
        });
    round.callListed(UUID.randomUUID(), REGISTRAR, "atrv1/head", () -> stopped("atrv1/head"));
    round.callLocal("atrv1/drive", () -> stopped("atrv1/drive"));
    round.callLocal(
        "atrv1/head",
        () -> {
          throw new ConnectException("phoenix does not answer");
        });
    round.callLocal("atrv1/arm", () -> stopped("atrv1/arm"));
    assertThat(round.outcomes())
        .containsExactlyInAnyOrder(
            stopped("atrv1/drive"), stopped("atrv1/head"), stopped("atrv1/arm"));
  }

  @Test
  void tellsWhatTheAnswersMean() {
    StopState before = stopped(Duration.ofSeconds(3), true, null); // whatever its clock says
    assertThat(List.of(stopped("a/b"), Outcome.ofStop("a/b", RUNNING, before)))
        .extracting(Outcome::inWords)
        .containsExactly(
            "a/b: stopped.", "a/b: was stopped already, since 2026-11-21T12:00:00Z, by ops.");
    StopState heldUp = stopped(Duration.ofSeconds(3), false, "its driver is held up");
    assertThat(Outcome.ofStop("a/b", RUNNING, heldUp))
        .returns("a/b: NOT AT REST: its driver is held up.", Outcome::inWords)
        .matches(each -> !each.result().isWell());
    StopState free = new StopState(false, "the chief", NOON, true, null);
    assertThat(Outcome.ofStop("a/b", RUNNING, free).result()).isEqualTo(Result.NOT_STOPPED);
    assertThat(Outcome.ofRelease("a/b", "the chief", free).inWords()).isEqualTo("a/b: released.");
    assertThat(Outcome.ofRelease("a/b", "ops", StopState.NEVER).inWords())
        .isEqualTo("a/b: was not stopped.");
    assertThat(Outcome.ofRelease("a/b", "ops", STOPPED).result()).isEqualTo(Result.NOT_RELEASED);
  }

  @Test
  void aSearchThatIsNotAnsweredHoldsUpNobodyWhoIsListed() throws Exception {
    round.findLocal(
        () -> {
          try {
            end.await();
          } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
          }
        });
    round.callListed(UUID.randomUUID(), REGISTRAR, "atrv1/drive", () -> stopped("atrv1/drive"));
    assertThat(well.poll(20, TimeUnit.SECONDS)).isEqualTo(stopped("atrv1/drive"));
  }

  @Test
  void whatASearchFindsIsWaitedForAndAFaultOfItIsReported() {
    round.findLocal(() -> round.callLocal("atrv1/drive", () -> stopped("atrv1/drive")));
    round.findLocal(
        () -> {
          throw new IllegalStateException("a fault");
        });
    assertThat(round.outcomes())
        .containsExactlyInAnyOrder(
            stopped("atrv1/drive"),
            new Outcome("the effectors of this host", Result.NOT_STOPPED, null, null, "a fault"));
  }

  @Test
  void ofSeveralOfOneNameEachHasToStop() {
    round.callListed(UUID.randomUUID(), REGISTRAR, "atrv1/drive", () -> stopped("atrv1/drive"));
    round.callLocal("atrv1/drive", () -> stopped("atrv1/drive"));
    round.callLocal(
        "atrv1/drive",
        () -> {
          throw new ConnectException("its process hangs");
        });
    assertThat(round.outcomes())
        .extracting(each -> each.result().isWell())
        .containsExactly(true, true, false);
  }

  private static StopReport report(List<String> robots, EffectorStop... stops) {
    return new StopReport(robots, List.of(stops), List.of());
  }

  private static EffectorStop confirmed(UUID id, String path) {
    return new EffectorStop(id, path, false, STOPPED, null);
  }

  @Test
  void aPhoenixConfirmsWithoutAnyLookupService() throws Exception {
    UUID id = UUID.randomUUID();
    round.askPhoenix(ROBOT, true, () -> report(List.of("atrv1"), confirmed(id, "atrv1/drive")));
    assertThat(well.poll(20, TimeUnit.SECONDS)).isEqualTo(stopped("atrv1/drive"));
    round.callListed(
        id,
        REGISTRAR,
        "atrv1/drive",
        () -> {
          throw new ConnectException("refused");
        });
    assertThat(round.outcomes()).containsExactly(stopped("atrv1/drive"));
  }

  @Test
  void aProxyThatSaysStoppedIsDoubtedWhereThePhoenixOfItsRobotDoesNotKnowIt() {
    UUID real = UUID.randomUUID();
    round.askPhoenix(ROBOT, true, () -> report(List.of("atrv1"), confirmed(real, "atrv1/drive")));
    round.callListed(real, REGISTRAR, "atrv1/drive", () -> stopped("atrv1/drive"));
    round.callListed(UUID.randomUUID(), REGISTRAR, "atrv1/fake", () -> stopped("atrv1/fake"));
    assertThat(round.outcomes())
        .extracting(Outcome::module, Outcome::result)
        .containsExactlyInAnyOrder(
            tuple("atrv1/drive", Result.STOPPED), tuple("atrv1/fake", Result.DOUBTFUL));
    assertThat(well).extracting(Outcome::module).containsOnly("atrv1/drive");
  }

  @Test
  void aProxyIsDoubtedWhereThePhoenixThatMayRunItIsSilent() {
    round.askPhoenix(
        ROBOT,
        true,
        () -> {
          throw new RemoteException("it does not answer");
        });
    round.callListed(UUID.randomUUID(), REGISTRAR, "atrv1/drive", () -> stopped("atrv1/drive"));
    assertThat(round.outcomes())
        .singleElement()
        .returns(Result.DOUBTFUL, Outcome::result)
        .satisfies(each -> assertThat(each.inWords()).contains("none answers at 192.0.2.7:1198"));
  }

  @Test
  void aProxyIsDoubtedWherePhoenixesAreTooManyToBeAsked() {
    for (int i = 0; i <= 64; i++) {
      round.askPhoenix(
          new Address("192.0.2." + i, 1198),
          false,
          () -> {
            throw new ConnectException(
                "refused", new java.net.ConnectException("Connection refused"));
          });
    }
    round.callListed(UUID.randomUUID(), REGISTRAR, "atrv1/drive", () -> stopped("atrv1/drive"));
    assertThat(round.outcomes())
        .singleElement()
        .returns(Result.DOUBTFUL, Outcome::result)
        .satisfies(each -> assertThat(each.inWords()).contains("none answers at 192.0.2.64:1198"));
  }

  @Test
  void anAddressThatMakesNoSenseIsSilentAndStopsNothingElse() {
    UUID id = UUID.randomUUID();
    round.askPhoenix(
        new Address("robot", 70000),
        true,
        () -> {
          throw new IllegalArgumentException("port out of range");
        });
    round.askPhoenix(ROBOT, true, () -> report(List.of("atrv1"), confirmed(id, "atrv1/drive")));
    assertThat(round.outcomes()).containsExactly(stopped("atrv1/drive"));
    assertThat(round.confirmations().silent()).containsExactly("robot:70000");
  }

  @Test
  void anEmbeddedRobotIsStoppedByItsOwnWordWhereNoPhoenixRuns() throws Exception {
    round.askPhoenix(
        ROBOT,
        true,
        () -> {
          throw new ConnectException(
              "refused", new java.net.ConnectException("Connection refused"));
        });
    round.callListed(UUID.randomUUID(), REGISTRAR, "atrv1/drive", () -> stopped("atrv1/drive"));
    assertThat(well.poll(20, TimeUnit.SECONDS)).isEqualTo(stopped("atrv1/drive"));
    assertThat(round.outcomes()).containsExactly(stopped("atrv1/drive"));
  }

  @Test
  void aPhoenixWhoseGroupWasStartedToBeStoppedIsAskedAgain() {
    UUID id = UUID.randomUUID();
    AtomicInteger orders = new AtomicInteger();
    round.askPhoenix(
        ROBOT,
        true,
        () ->
            orders.incrementAndGet() == 1
                ? new StopReport(
                    List.of("atrv1"),
                    List.of(),
                    List.of(new UnconfirmedGroup("atrv1", "atrv1.wheels", "it is started")))
                : report(List.of("atrv1"), confirmed(id, "atrv1/drive")));
    assertThat(round.outcomes()).containsExactly(stopped("atrv1/drive"));
    assertThat(orders).hasValue(2);
  }

  @Test
  void aGroupThatDoesNotAnswerItsPhoenixIsADoubtAlsoWhereNothingElseIsKnownOfIt() {
    round.askPhoenix(
        ROBOT,
        true,
        () ->
            new StopReport(
                List.of("atrv1"),
                List.of(),
                List.of(new UnconfirmedGroup("atrv1", "atrv1.wheels", "it hangs"))));
    assertThat(round.outcomes())
        .singleElement()
        .returns("atrv1/ (group atrv1.wheels): DOUBTFUL: it hangs.", Outcome::inWords);
  }

  @Test
  void proxiesThatNeverAnswerDelayNoPhoenix() throws Exception {
    for (int i = 0; i < 3000; i++) {
      round.callListed(UUID.randomUUID(), REGISTRAR, "fake" + i + "/drive", this::beSilent);
    }
    UUID id = UUID.randomUUID();
    round.askPhoenix(ROBOT, true, () -> report(List.of("atrv1"), confirmed(id, "atrv1/drive")));
    assertThat(well.poll(20, TimeUnit.SECONDS)).isEqualTo(stopped("atrv1/drive"));
  }
}
