package org.dfra.cli.stop;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.Map;
import java.util.UUID;
import org.dfra.cli.stop.Outcome.Result;
import org.dfra.cli.stop.PhoenixAddresses.Address;
import org.dfra.cli.stop.PhoenixAddresses.Origin;
import org.dfra.flow.effector.EmergencyStopState;
import org.dfra.river.phoenix.stop.EffectorStopResult;
import org.dfra.river.phoenix.stop.StopReport;
import org.junit.jupiter.api.Test;

class StopMergeTest {

  private static final Instant NOON = Instant.parse("2026-11-21T12:00:00Z");
  private static final UUID ID = new UUID(1, 2);
  private static final String PATH = "atrv1/drive";

  private final StopMerge merge = new StopMerge("ops", () -> Duration.ofSeconds(2));

  private static EffectorStopResult answered(boolean wasStopped, String by, Duration age) {
    return new EffectorStopResult(
        ID, PATH, wasStopped, new EmergencyStopState(true, by, NOON, true, null, age), null);
  }

  private static Confirmations confirmations(EffectorStopResult... stops) {
    return reported(new StopReport(List.of("atrv1"), List.of(stops), List.of()));
  }

  /** Of one phoenix, which reports several times. */
  private static Confirmations reported(StopReport... reports) {
    return new Confirmations(List.of(answer(7, reports)));
  }

  private static PhoenixAnswer answer(int computer, StopReport... reports) {
    Address address = new Address("192.0.2." + computer, 1198);
    return PhoenixAnswer.of(address, Origin.NAMED, List.of(reports));
  }

  private static StopMerge.ProxyClaim claim() {
    return new StopMerge.ProxyClaim(ID, PATH, "192.0.2.7", stopped());
  }

  private static Outcome stopped() {
    return new Outcome(PATH, Result.STOPPED, "ops", NOON, null);
  }

  @Test
  void distinguishesItsOwnStopFromAnEarlierOne() {
    assertThat(merge.ofPhoenix(answered(false, "ops", Duration.ofSeconds(1))).result())
        .isEqualTo(Result.STOPPED);
    assertThat(merge.ofPhoenix(answered(true, "ops", Duration.ofSeconds(1))).result())
        .as("by another way of this command")
        .isEqualTo(Result.STOPPED);
    assertThat(merge.ofPhoenix(answered(true, "ops", Duration.ofSeconds(3))).result())
        .isEqualTo(Result.ALREADY_STOPPED);
    assertThat(merge.ofPhoenix(answered(true, "the chief", Duration.ofSeconds(1))).result())
        .as("by somebody else meanwhile")
        .isEqualTo(Result.ALREADY_STOPPED);
  }

  @Test
  void aDriverThatIsHeldUpIsNotConfirmedByAProxy() {
    EffectorStopResult heldUp =
        new EffectorStopResult(
            ID, PATH, false, new EmergencyStopState(true, "ops", NOON, false, "held up"), null);
    assertThat(merge.merge(List.of(claim()), Map.of(), confirmations(heldUp)))
        .extracting(Outcome::result)
        .containsExactly(Result.DRIVER_NOT_STOPPED);
  }

  @Test
  void anEffectorThatDoesNotAnswerItsPhoenixIsDoubtedWhateverItsProxySays() {
    EffectorStopResult mute =
        new EffectorStopResult(ID, PATH, false, null, "it did not answer within 0.9 s");
    assertThat(merge.merge(List.of(claim()), Map.of(), confirmations(mute)))
        .singleElement()
        .returns(Result.UNCONFIRMED, Outcome::result)
        .satisfies(each -> assertThat(each.reason()).endsWith("it did not answer within 0.9 s"));
    assertThat(merge.merge(List.of(), Map.of(), confirmations(mute)))
        .extracting(Outcome::result)
        .containsExactly(Result.NOT_STOPPED);
  }

  @Test
  void phoenixsAdministratorConfirmsToo() {
    EffectorStopResult mute =
        new EffectorStopResult(ID, PATH, false, null, "it did not answer within 0.9 s");
    assertThat(merge.merge(List.of(), Map.of(PATH, List.of(stopped())), confirmations(mute)))
        .containsExactly(stopped());
    assertThat(merge.merge(List.of(claim()), Map.of(PATH, List.of(stopped())), confirmations()))
        .as("one effector, reached in two ways")
        .containsExactly(stopped());
  }

  @Test
  void theLatestAnswerCountsUnlessAnEarlierOneConfirmedTheStop() {
    EffectorStopResult good = answered(false, "ops", Duration.ofSeconds(1));
    EffectorStopResult mute = new EffectorStopResult(ID, PATH, false, null, "it hangs");
    for (List<EffectorStopResult> order : List.of(List.of(good, mute), List.of(mute, good))) {
      StopReport[] reports =
          order.stream()
              .map(each -> new StopReport(List.of("atrv1"), List.of(each), List.of()))
              .toArray(StopReport[]::new);
      assertThat(reported(reports).stops()).containsEntry(ID, good);
    }
  }

  @Test
  void aPhoenixThatKnowsNothingOfAnEffectorCannotConfirmWhatItsOwnDoesNot() {
    EffectorStopResult mute = new EffectorStopResult(ID, PATH, false, null, "it hangs");
    StopReport real = new StopReport(List.of("atrv1"), List.of(mute), List.of());
    StopReport fake =
        new StopReport(
            List.of("atrv1"), List.of(answered(false, "ops", Duration.ofSeconds(1))), List.of());
    for (List<StopReport> order : List.of(List.of(real, fake), List.of(fake, real))) {
      Confirmations both =
          new Confirmations(List.of(answer(7, order.get(0)), answer(8, order.get(1))));
      assertThat(both.isComplete()).isFalse();
      assertThat(merge.merge(List.of(), Map.of(), both))
          .extracting(Outcome::result)
          .containsExactly(Result.NOT_STOPPED);
    }
  }
}
