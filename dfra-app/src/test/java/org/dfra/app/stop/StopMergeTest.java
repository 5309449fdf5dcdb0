package org.dfra.app.stop;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.Map;
import java.util.UUID;
import org.dfra.app.stop.Outcome.Result;
import org.dfra.flow.effector.StopState;
import org.dfra.river.phoenix.stop.EffectorStop;
import org.dfra.river.phoenix.stop.StopReport;
import org.junit.jupiter.api.Test;

class StopMergeTest {

  private static final Instant NOON = Instant.parse("2026-11-21T12:00:00Z");
  private static final UUID ID = new UUID(1, 2);
  private static final String PATH = "atrv1/drive";

  private final StopMerge merge = new StopMerge("ops", () -> Duration.ofSeconds(2));

  private static EffectorStop answered(boolean wasStopped, String by, Duration age) {
    return new EffectorStop(
        ID, PATH, wasStopped, new StopState(true, by, NOON, true, null, age), null);
  }

  private static Confirmations confirmations(EffectorStop... stops) {
    return Confirmations.of(
        List.of(List.of(new StopReport(List.of("atrv1"), List.of(stops), List.of()))), List.of());
  }

  private static Outcome stopped() {
    return new Outcome(PATH, Result.STOPPED, "ops", NOON, null);
  }

  @Test
  void tellsAStopOfItsOwnFromOneBefore() {
    assertThat(merge.ofPhoenix(answered(false, "ops", Duration.ofSeconds(1))).result())
        .isEqualTo(Result.STOPPED);
    assertThat(merge.ofPhoenix(answered(true, "ops", Duration.ofSeconds(1))).result())
        .as("by another way of this command")
        .isEqualTo(Result.STOPPED);
    assertThat(merge.ofPhoenix(answered(true, "ops", Duration.ofSeconds(3))).result())
        .isEqualTo(Result.STOPPED_ALREADY);
    assertThat(merge.ofPhoenix(answered(true, "the chief", Duration.ofSeconds(1))).result())
        .as("by somebody else meanwhile")
        .isEqualTo(Result.STOPPED_ALREADY);
  }

  @Test
  void aDriverThatIsHeldUpIsNotConfirmedByAProxy() {
    EffectorStop heldUp =
        new EffectorStop(ID, PATH, false, new StopState(true, "ops", NOON, false, "held up"), null);
    assertThat(
            merge.merge(
                List.of(new StopMerge.Claim(ID, PATH, stopped())), Map.of(), confirmations(heldUp)))
        .extracting(Outcome::result)
        .containsExactly(Result.NOT_AT_REST);
  }

  @Test
  void anEffectorThatDoesNotAnswerItsPhoenixIsDoubtedWhateverItsProxySays() {
    EffectorStop mute = new EffectorStop(ID, PATH, false, null, "it did not answer within 0.9 s");
    assertThat(
            merge.merge(
                List.of(new StopMerge.Claim(ID, PATH, stopped())), Map.of(), confirmations(mute)))
        .singleElement()
        .returns(Result.DOUBTFUL, Outcome::result)
        .satisfies(each -> assertThat(each.reason()).endsWith("it did not answer within 0.9 s"));
    assertThat(merge.merge(List.of(), Map.of(), confirmations(mute)))
        .extracting(Outcome::result)
        .containsExactly(Result.NOT_STOPPED);
  }

  @Test
  void phoenixsAdministratorConfirmsToo() {
    EffectorStop mute = new EffectorStop(ID, PATH, false, null, "it did not answer within 0.9 s");
    assertThat(merge.merge(List.of(), Map.of(PATH, List.of(stopped())), confirmations(mute)))
        .containsExactly(stopped());
    assertThat(
            merge.merge(
                List.of(new StopMerge.Claim(ID, PATH, stopped())),
                Map.of(PATH, List.of(stopped())),
                confirmations()))
        .as("one effector, reached in two ways")
        .containsExactly(stopped());
  }

  @Test
  void theLatestAnswerCountsUnlessAnEarlierOneConfirmedTheStop() {
    EffectorStop good = answered(false, "ops", Duration.ofSeconds(1));
    EffectorStop mute = new EffectorStop(ID, PATH, false, null, "it hangs");
    for (List<EffectorStop> order : List.of(List.of(good, mute), List.of(mute, good))) {
      List<StopReport> reports =
          order.stream()
              .map(each -> new StopReport(List.of("atrv1"), List.of(each), List.of()))
              .toList();
      assertThat(Confirmations.of(List.of(reports), List.of()).stops()).containsEntry(ID, good);
    }
  }

  @Test
  void aPhoenixThatKnowsNothingOfAnEffectorCannotConfirmWhatItsOwnDoesNot() {
    EffectorStop mute = new EffectorStop(ID, PATH, false, null, "it hangs");
    StopReport real = new StopReport(List.of("atrv1"), List.of(mute), List.of());
    StopReport fake =
        new StopReport(
            List.of("atrv1"), List.of(answered(false, "ops", Duration.ofSeconds(1))), List.of());
    for (List<StopReport> order : List.of(List.of(real, fake), List.of(fake, real))) {
      List<List<StopReport>> reports = order.stream().map(each -> List.of(each)).toList();
      Confirmations both = Confirmations.of(reports, List.of());
      assertThat(both.isComplete()).isFalse();
      assertThat(merge.merge(List.of(), Map.of(), both))
          .extracting(Outcome::result)
          .containsExactly(Result.NOT_STOPPED);
    }
  }
}
