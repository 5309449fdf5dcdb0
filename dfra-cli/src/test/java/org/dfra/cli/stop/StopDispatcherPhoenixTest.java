package org.dfra.cli.stop;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.tuple;

import java.rmi.ConnectException;
import java.rmi.RemoteException;
import java.util.List;
import java.util.UUID;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import org.dfra.cli.stop.Outcome.Result;
import org.dfra.cli.stop.PhoenixAddresses.Address;
import org.dfra.cli.stop.PhoenixAddresses.Origin;
import org.dfra.river.phoenix.stop.EffectorStopResult;
import org.dfra.river.phoenix.stop.StopReport;
import org.dfra.river.phoenix.stop.UnconfirmedGroup;
import org.junit.jupiter.api.Test;

/** What phoenixes confirm of a round, and what is doubted since they do not. */
class StopDispatcherPhoenixTest extends StopDispatcherFixture {

  private static StopReport report(List<String> robots, EffectorStopResult... stops) {
    return new StopReport(robots, List.of(stops), List.of());
  }

  private static EffectorStopResult confirmed(UUID id, String path) {
    return new EffectorStopResult(id, path, false, STOPPED, null);
  }

  @Test
  void theWordOfAProxyIsPublishedWhenItIsKnownWhichPhoenixItsComputerHas() throws Exception {
    UUID elsewhere = UUID.randomUUID();
    round.callListed(
        UUID.randomUUID(), elsewhere, null, "theta/drive", () -> stopped("theta/drive"));
    round.callListed(
        UUID.randomUUID(), REGISTRAR, null, "atrv1/drive", () -> stopped("atrv1/drive"));
    assertThat(well.poll(20, TimeUnit.SECONDS)).isEqualTo(stopped("atrv1/drive"));
    round.requestPhoenix(
        new Address("192.0.2.9", 1198),
        Origin.DISCOVERY,
        () -> new StopReport(List.of("theta"), List.of(), List.of()));
    round.registrarFound(elsewhere, "192.0.2.9");
    assertThat(round.awaitOutcomes())
        .extracting(Outcome::module, Outcome::result)
        .containsExactlyInAnyOrder(
            tuple("theta/drive", Result.UNCONFIRMED), tuple("atrv1/drive", Result.STOPPED));
    assertThat(well).isEmpty();
  }

  @Test
  void aPhoenixThatOnlyDiscoveryNamedConfirmsOnlyWhatItsLookupServiceLists() {
    UUID own = UUID.randomUUID();
    UUID another = UUID.randomUUID();
    round.requestPhoenix(
        ROBOT,
        Origin.DISCOVERY,
        () -> report(List.of("atrv1"), confirmed(own, "atrv1/drive"), confirmed(another, "x/y")));
    round.callListed(own, REGISTRAR, null, "atrv1/drive", () -> stopped("atrv1/drive"));
    assertThat(round.awaitOutcomes())
        .extracting(Outcome::module, Outcome::result)
        .containsExactlyInAnyOrder(
            tuple("atrv1/drive", Result.STOPPED), tuple("x/y", Result.UNCONFIRMED));
    assertThat(well).as("it is not published before everything is known").isEmpty();
  }

  @Test
  void aNameThatIsOfThisComputerIsNotSilent() {
    round.requestPhoenix(new Address("this-computer", 1198), Origin.DISCOVERY, () -> null);
    round.callListed(
        UUID.randomUUID(), REGISTRAR, null, "atrv1/drive", () -> stopped("atrv1/drive"));
    assertThat(round.awaitOutcomes()).containsExactly(stopped("atrv1/drive"));
  }

  @Test
  void aPhoenixConfirmsWithoutAnyLookupService() throws Exception {
    UUID id = UUID.randomUUID();
    round.requestPhoenix(
        ROBOT, Origin.NAMED, () -> report(List.of("atrv1"), confirmed(id, "atrv1/drive")));
    assertThat(well.poll(20, TimeUnit.SECONDS)).isEqualTo(stopped("atrv1/drive"));
    round.callListed(
        id,
        REGISTRAR,
        null,
        "atrv1/drive",
        () -> {
          throw new ConnectException("refused");
        });
    assertThat(round.awaitOutcomes()).containsExactly(stopped("atrv1/drive"));
  }

  @Test
  void aProxyThatSaysStoppedIsDoubtedWhereThePhoenixOfItsRobotDoesNotKnowIt() {
    UUID real = UUID.randomUUID();
    round.requestPhoenix(
        ROBOT, Origin.NAMED, () -> report(List.of("atrv1"), confirmed(real, "atrv1/drive")));
    round.callListed(real, REGISTRAR, null, "atrv1/drive", () -> stopped("atrv1/drive"));
    round.callListed(UUID.randomUUID(), REGISTRAR, null, "atrv1/fake", () -> stopped("atrv1/fake"));
    assertThat(round.awaitOutcomes())
        .extracting(Outcome::module, Outcome::result)
        .containsExactlyInAnyOrder(
            tuple("atrv1/drive", Result.STOPPED), tuple("atrv1/fake", Result.UNCONFIRMED));
    assertThat(well).extracting(Outcome::module).containsOnly("atrv1/drive");
  }

  @Test
  void aProxyIsDoubtedWhereThePhoenixThatMayRunItIsSilent() {
    round.requestPhoenix(
        ROBOT,
        Origin.NAMED,
        () -> {
          throw new RemoteException("it does not answer");
        });
    round.callListed(
        UUID.randomUUID(), REGISTRAR, null, "atrv1/drive", () -> stopped("atrv1/drive"));
    assertThat(round.awaitOutcomes())
        .singleElement()
        .returns(Result.UNCONFIRMED, Outcome::result)
        .satisfies(each -> assertThat(each.inWords()).contains("none answers at 192.0.2.7:1198"));
  }

  @Test
  void aProxyIsDoubtedWherePhoenixesAreTooManyToBeAsked() {
    for (int i = 0; i <= 64; i++) {
      round.requestPhoenix(
          new Address("192.0.2." + i, 1198),
          Origin.DISCOVERY,
          () -> {
            throw new ConnectException(
                "refused", new java.net.ConnectException("Connection refused"));
          });
    }
    round.callListed(
        UUID.randomUUID(), REGISTRAR, null, "atrv1/drive", () -> stopped("atrv1/drive"));
    assertThat(round.awaitOutcomes())
        .singleElement()
        .returns(Result.UNCONFIRMED, Outcome::result)
        .satisfies(each -> assertThat(each.inWords()).contains("none answers at 192.0.2.64:1198"));
  }

  @Test
  void anAddressThatMakesNoSenseIsSilentAndStopsNothingElse() {
    UUID id = UUID.randomUUID();
    round.requestPhoenix(
        new Address("robot", 70000),
        Origin.NAMED,
        () -> {
          throw new IllegalArgumentException("port out of range");
        });
    round.requestPhoenix(
        ROBOT, Origin.NAMED, () -> report(List.of("atrv1"), confirmed(id, "atrv1/drive")));
    assertThat(round.awaitOutcomes()).containsExactly(stopped("atrv1/drive"));
    assertThat(round.confirmations().unresponsive()).containsExactly("robot:70000");
  }

  @Test
  void anEmbeddedRobotIsStoppedByItsOwnWordWhereNoPhoenixRuns() throws Exception {
    round.requestPhoenix(
        ROBOT,
        Origin.NAMED,
        () -> {
          throw new ConnectException(
              "refused", new java.net.ConnectException("Connection refused"));
        });
    round.callListed(
        UUID.randomUUID(), REGISTRAR, null, "atrv1/drive", () -> stopped("atrv1/drive"));
    assertThat(well.poll(20, TimeUnit.SECONDS)).isEqualTo(stopped("atrv1/drive"));
    assertThat(round.awaitOutcomes()).containsExactly(stopped("atrv1/drive"));
  }

  @Test
  void aPhoenixWhoseGroupWasStartedToBeStoppedIsAskedAgain() {
    UUID id = UUID.randomUUID();
    AtomicInteger orders = new AtomicInteger();
    round.requestPhoenix(
        ROBOT,
        Origin.NAMED,
        () ->
            orders.incrementAndGet() == 1
                ? new StopReport(
                    List.of("atrv1"),
                    List.of(),
                    List.of(new UnconfirmedGroup("atrv1", "atrv1.wheels", "it is started")))
                : report(List.of("atrv1"), confirmed(id, "atrv1/drive")));
    assertThat(round.awaitOutcomes()).containsExactly(stopped("atrv1/drive"));
    assertThat(orders).hasValue(2);
  }

  @Test
  void aGroupThatDoesNotAnswerItsPhoenixIsADoubtAlsoWhereNothingElseIsKnownOfIt() {
    round.requestPhoenix(
        ROBOT,
        Origin.NAMED,
        () ->
            new StopReport(
                List.of("atrv1"),
                List.of(),
                List.of(new UnconfirmedGroup("atrv1", "atrv1.wheels", "it hangs"))));
    assertThat(round.awaitOutcomes())
        .singleElement()
        .returns("atrv1/ (group atrv1.wheels): DOUBTFUL: it hangs.", Outcome::inWords);
  }

  @Test
  void proxiesThatNeverAnswerDelayNoPhoenix() throws Exception {
    for (int i = 0; i < 3000; i++) {
      round.callListed(UUID.randomUUID(), REGISTRAR, null, "fake" + i + "/drive", this::beSilent);
    }
    UUID id = UUID.randomUUID();
    round.requestPhoenix(
        ROBOT, Origin.NAMED, () -> report(List.of("atrv1"), confirmed(id, "atrv1/drive")));
    assertThat(well.poll(20, TimeUnit.SECONDS)).isEqualTo(stopped("atrv1/drive"));
  }
}
