package org.dfra.cli.stop;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.tuple;

import java.time.Duration;
import java.time.Instant;
import java.util.Arrays;
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

/**
 * What the word of a phoenix counts that only a lookup service named which discovery found: it may
 * be a stranger's. Here 192.0.2.7 is the computer of the robot atrv1, and 192.0.2.66 a stranger's.
 */
class DiscoveredPhoenixTest {

  private static final String ROBOT = "192.0.2.7";
  private static final String STRANGER = "192.0.2.66";
  private static final UUID ID = new UUID(1, 2);
  private static final String PATH = "atrv1/drive";
  private static final EmergencyStopState STATE =
      new EmergencyStopState(true, "ops", Instant.parse("2026-11-21T12:00:00Z"), true, null);
  private static final EffectorStopResult STOPPED =
      new EffectorStopResult(ID, PATH, false, STATE, null);
  private static final EffectorStopResult HANGS =
      new EffectorStopResult(ID, PATH, false, null, "it hangs");
  private static final Origin CONFIGURED = Origin.NAMED;
  private static final Origin FOUND = Origin.DISCOVERY;

  private final StopMerge merge = new StopMerge("ops", () -> Duration.ofSeconds(2));

  private static PhoenixAnswer reported(String host, Origin origin, EffectorStopResult... stops) {
    return reported(host, origin, List.of("atrv1"), stops);
  }

  private static PhoenixAnswer reported(
      String host, Origin origin, List<String> robots, EffectorStopResult... stops) {
    StopReport report = new StopReport(robots, List.of(stops), List.of());
    return PhoenixAnswer.of(new Address(host, 1198), origin, List.of(report));
  }

  private static PhoenixAnswer silent(String host, Origin origin) {
    return PhoenixAnswer.unresponsive(new Address(host, 1198), origin);
  }

  private static StopMerge.ProxyClaim listed(String host, Result result) {
    return new StopMerge.ProxyClaim(ID, PATH, host, new Outcome(PATH, result, "ops", null, null));
  }

  private List<Outcome> merged(List<StopMerge.ProxyClaim> listings, PhoenixAnswer... answers) {
    return merge.merge(listings, Map.of(), new Confirmations(Arrays.asList(answers)));
  }

  private void assertUncertain(
      String why, List<StopMerge.ProxyClaim> listings, PhoenixAnswer... answers) {
    assertThat(merged(listings, answers))
        .singleElement()
        .returns(PATH, Outcome::module)
        .returns(Result.UNCONFIRMED, Outcome::result)
        .satisfies(each -> assertThat(each.reason()).contains(", and " + why));
  }

  private void assertStopped(List<StopMerge.ProxyClaim> listings, PhoenixAnswer... answers) {
    assertThat(merged(listings, answers))
        .extracting(Outcome::module, Outcome::result)
        .containsExactly(tuple(PATH, Result.STOPPED));
  }

  @Test
  void itConfirmsWhatALookupServiceOfItsComputerListsAlsoWhereTheProxyIsSilent() {
    assertStopped(List.of(listed(ROBOT, Result.STOPPED)), reported(ROBOT, FOUND, STOPPED));
    assertStopped(List.of(listed(ROBOT, Result.NOT_STOPPED)), reported(ROBOT, FOUND, STOPPED));
  }

  @Test
  void itConfirmsNothingThatNoLookupServiceOfItsComputerLists() {
    assertUncertain("no lookup service of that", List.of(), reported(STRANGER, FOUND, STOPPED));
    assertUncertain(
        "no lookup service of that",
        List.of(listed(ROBOT, Result.STOPPED)),
        reported(STRANGER, FOUND, STOPPED));
  }

  @Test
  void itConfirmsNoRobotThatAConfiguredPhoenixHas() {
    assertUncertain(
        "the configured phoenix of its robot does not",
        List.of(listed(STRANGER, Result.STOPPED)),
        reported(ROBOT, CONFIGURED),
        reported(STRANGER, FOUND, STOPPED));
  }

  @Test
  void itConfirmsNothingWhileAConfiguredPhoenixIsSilent() {
    assertUncertain(
        "none of the configured ones answers at 192.0.2.7:1198",
        List.of(listed(STRANGER, Result.STOPPED)),
        silent(ROBOT, CONFIGURED),
        reported(STRANGER, FOUND, STOPPED));
  }

  @Test
  void itConfirmsNoEffectorThatIsListedElsewhereAndIsNotConfirmedThere() {
    List<StopMerge.ProxyClaim> both =
        List.of(listed(STRANGER, Result.STOPPED), listed(ROBOT, Result.STOPPED));
    PhoenixAnswer strangers = reported(STRANGER, FOUND, STOPPED);
    assertUncertain("the phoenix at 192.0.2.7, where it", both, strangers, silent(ROBOT, FOUND));
    assertUncertain("the phoenix at 192.0.2.7, where it", both, strangers, reported(ROBOT, FOUND));
    assertThat(merged(both, strangers, reported(ROBOT, FOUND, HANGS)))
        .as("one of both is false")
        .extracting(Outcome::result)
        .containsExactly(Result.UNCONFIRMED);
  }

  @Test
  void anEffectorThatIsListedWhereNoPhoenixHasItsRobotSaysSoItself() {
    PhoenixAnswer its = reported(ROBOT, FOUND, STOPPED);
    PhoenixAnswer others = reported("192.0.2.9", FOUND, List.of("theta"));
    StopMerge.ProxyClaim own = listed(ROBOT, Result.STOPPED);
    for (String elsewhere : Arrays.asList("192.0.2.8", "192.0.2.9", null)) {
      assertStopped(List.of(own, listed(elsewhere, Result.STOPPED)), its, others);
      assertUncertain(
          "its proxy from another lookup service does not",
          List.of(own, listed(elsewhere, Result.NOT_STOPPED)),
          its,
          others);
    }
  }

  @Test
  void aPhoenixThatIsConfiguredIsBelieved() {
    assertStopped(List.of(), reported(ROBOT, CONFIGURED, STOPPED));
    assertStopped(
        List.of(listed(STRANGER, Result.NOT_STOPPED)),
        reported(STRANGER, FOUND, HANGS),
        reported(ROBOT, CONFIGURED, STOPPED));
    assertThat(
            merged(
                List.of(listed(STRANGER, Result.STOPPED)),
                reported(STRANGER, FOUND, STOPPED),
                reported(ROBOT, CONFIGURED, HANGS)))
        .extracting(Outcome::module, Outcome::result)
        .containsExactly(tuple(PATH, Result.UNCONFIRMED));
  }

  @Test
  void oneThatTakesAnIdentityUnderAnotherPathHidesNoEffector() {
    EffectorStopResult renamed = new EffectorStopResult(ID, "forged/drive", false, STATE, null);
    StopMerge.ProxyClaim real = listed(ROBOT, Result.NOT_STOPPED);
    assertThat(merged(List.of(real), reported(STRANGER, FOUND, List.of("forged"), renamed)))
        .extracting(Outcome::module, Outcome::result)
        .containsExactlyInAnyOrder(
            tuple("forged/drive", Result.UNCONFIRMED), tuple(PATH, Result.NOT_STOPPED));
  }
}
