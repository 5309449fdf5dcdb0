package org.dfra.cli.stop;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.tuple;

import java.rmi.ConnectException;
import java.time.Duration;
import java.util.List;
import java.util.UUID;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import org.dfra.cli.stop.Outcome.Result;
import org.dfra.flow.effector.EmergencyStopState;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** How effectors are called, by their proxies and on their own host, and what they answer. */
class StopDispatcherTest extends StopDispatcherFixture {

  @Test
  void oneThatIsSilentHoldsUpNoOther() throws Exception {
    for (int i = 0; i < 50; i++) {
      round.callListed(UUID.randomUUID(), REGISTRAR, null, "mute/drive" + i, this::beSilent);
    }
    round.callListed(
        UUID.randomUUID(), REGISTRAR, null, "atrv1/drive", () -> stopped("atrv1/drive"));
    assertThat(well.poll(20, TimeUnit.SECONDS)).isEqualTo(stopped("atrv1/drive"));
  }

  /** Under other names than an honest effector's, and under that of its robot. */
  @ParameterizedTest
  @ValueSource(strings = {"fake%s/drive", "atrv1/fake%s"})
  void fiveHundredThatAreSilentHoldUpNoOther(String path) throws Exception {
    for (int i = 0; i < 500; i++) {
      round.callListed(UUID.randomUUID(), REGISTRAR, null, path.formatted(i), this::beSilent);
    }
    round.callListed(
        UUID.randomUUID(), REGISTRAR, null, "atrv1/drive", () -> stopped("atrv1/drive"));
    assertThat(well.poll(15, TimeUnit.SECONDS)) // less than the patience, which is 20 s
        .isEqualTo(stopped("atrv1/drive"));
  }

  @Test
  void whatIsNotAnsweredInTimeIsTriedOnceMoreAndReported() {
    AtomicInteger calls = new AtomicInteger();
    try (StopDispatcher brief =
        new StopDispatcher(
            Result.NOT_STOPPED, Duration.ofMillis(50), () -> false, well::add, merge)) {
      brief.callListed(
          UUID.randomUUID(),
          REGISTRAR,
          null,
          "mute/drive",
          () -> {
            calls.incrementAndGet();
            return beSilent();
          });
      assertThat(brief.awaitOutcomes())
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
          null,
          "atrv1/drive",
          () -> {
            if (calls.incrementAndGet() == 1) {
              throw new ConnectException("refused\nnested exception is: so and so");
            }
            return stopped("atrv1/drive");
          });
    }
    assertThat(round.awaitOutcomes()).containsExactly(stopped("atrv1/drive"));
    assertThat(calls).hasValue(2);
  }

  @Test
  void aStrangersProxyUnderItsIdentityTakesNoEffectorsPlace() {
    UUID id = UUID.randomUUID();
    AtomicInteger calls = new AtomicInteger();
    round.callListed(
        id,
        UUID.randomUUID(),
        null,
        "atrv1/drive",
        () -> {
          throw new ConnectException("it is a stranger's");
        });
    round.callListed(
        id,
        UUID.randomUUID(),
        null,
        "atrv1/drive",
        () -> {
          calls.incrementAndGet();
          return stopped("atrv1/drive");
        });
    assertThat(round.awaitOutcomes())
        .as("one of both is the effector, and which is not known")
        .extracting(Outcome::module, Outcome::result)
        .containsExactly(tuple("atrv1/drive", Result.NOT_STOPPED));
    assertThat(calls).hasValue(1);
  }

  @Test
  void whatFailsTwiceIsReportedInOneLine() {
    round.callListed(
        UUID.randomUUID(),
        REGISTRAR,
        null,
        "atrv1/drive",
        () -> {
          throw new ConnectException("refused\nnested exception is: so and so");
        });
    assertThat(round.awaitOutcomes())
        .singleElement()
        .returns(Result.NOT_STOPPED, Outcome::result)
        .returns("atrv1/drive: NOT STOPPED: refused.", Outcome::inWords);
  }

  @Test
  void itsOwnHostReachesWhatNoLookupServiceDoes() {
    round.callListed(
        UUID.randomUUID(),
        REGISTRAR,
        null,
        "atrv1/drive",
        () -> {
          throw new ConnectException("refused");
        });
    round.callListed(UUID.randomUUID(), REGISTRAR, null, "atrv1/head", () -> stopped("atrv1/head"));
    round.callLocal("atrv1/drive", () -> stopped("atrv1/drive"));
    round.callLocal(
        "atrv1/head",
        () -> {
          throw new ConnectException("phoenix does not answer");
        });
    round.callLocal("atrv1/arm", () -> stopped("atrv1/arm"));
    assertThat(round.awaitOutcomes())
        .containsExactlyInAnyOrder(
            stopped("atrv1/drive"), stopped("atrv1/head"), stopped("atrv1/arm"));
  }

  @Test
  void reportsWhatTheAnswersMean() {
    EmergencyStopState before =
        stopped(Duration.ofSeconds(3), true, null); // whatever its clock says
    assertThat(List.of(stopped("a/b"), Outcome.ofStop("a/b", RUNNING, before)))
        .extracting(Outcome::inWords)
        .containsExactly(
            "a/b: stopped.", "a/b: was stopped already, since 2026-11-21T12:00:00Z, by ops.");
    EmergencyStopState heldUp = stopped(Duration.ofSeconds(3), false, "its driver is held up");
    assertThat(Outcome.ofStop("a/b", RUNNING, heldUp))
        .returns("a/b: DRIVER NOT STOPPED: its driver is held up.", Outcome::inWords)
        .matches(each -> !each.result().isWell());
    EmergencyStopState free = new EmergencyStopState(false, "the chief", NOON, true, null);
    assertThat(Outcome.ofStop("a/b", RUNNING, free).result()).isEqualTo(Result.NOT_STOPPED);
    assertThat(Outcome.ofRelease("a/b", "the chief", free).inWords()).isEqualTo("a/b: released.");
    assertThat(Outcome.ofRelease("a/b", "ops", EmergencyStopState.NEVER).inWords())
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
    round.callListed(
        UUID.randomUUID(), REGISTRAR, null, "atrv1/drive", () -> stopped("atrv1/drive"));
    assertThat(well.poll(20, TimeUnit.SECONDS)).isEqualTo(stopped("atrv1/drive"));
  }

  @Test
  void whatASearchFindsIsWaitedForAndAFaultOfItIsReported() {
    round.findLocal(() -> round.callLocal("atrv1/drive", () -> stopped("atrv1/drive")));
    round.findLocal(
        () -> {
          throw new IllegalStateException("a fault");
        });
    assertThat(round.awaitOutcomes())
        .containsExactlyInAnyOrder(
            stopped("atrv1/drive"),
            new Outcome("the effectors of this host", Result.NOT_STOPPED, null, null, "a fault"));
  }

  @Test
  void ofSeveralOfOneNameEachHasToStop() {
    round.callListed(
        UUID.randomUUID(), REGISTRAR, null, "atrv1/drive", () -> stopped("atrv1/drive"));
    round.callLocal("atrv1/drive", () -> stopped("atrv1/drive"));
    round.callLocal(
        "atrv1/drive",
        () -> {
          throw new ConnectException("its process hangs");
        });
    assertThat(round.awaitOutcomes())
        .extracting(each -> each.result().isWell())
        .containsExactly(true, true, false);
  }
}
