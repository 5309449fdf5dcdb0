package org.dfra.drivers.pantilt.ptu;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;
import static org.dfra.drivers.fixture.Modules.await;
import static org.dfra.drivers.fixture.Modules.parameter;

import java.time.Duration;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import org.dfra.core.config.ConfigurationException;
import org.dfra.drivers.fixture.ScriptedLink;
import org.dfra.flow.effector.CommandLease;
import org.dfra.flow.effector.PanTiltCommand.Halt;
import org.dfra.flow.effector.PanTiltCommand.PointAt;
import org.dfra.lifecycle.Readiness;
import org.dfra.module.Diagnosis;
import org.dfra.module.NotReadyException;
import org.dfra.persona.PanTiltAttributes;
import org.junit.jupiter.api.Test;

/** The driver alone: the test is the unit and the time. */
class PtuImplTest extends PtuFixture {

  @Test
  void setsTheUnitUpAndAsksWhatItCan() {
    awaitWords();
    assertThat(next()).isEqualTo("ED ");
    assertThat(next()).isEqualTo("FT ");
    assertThat(next()).isEqualTo("I ");
    say("ED *\r\nFT *\r\n*\r\n");
    for (String question : QUESTIONS) {
      assertThat(next()).isEqualTo(question + " ");
      say("* " + ANSWERS.get(question) + "\r\n");
    }
    assertThat(next()).isEqualTo("PP ");
    say("* 100\r\n");
    assertThat(next()).isEqualTo("TP ");
    say("* -50\r\n");
    awaitReadiness(Readiness.READY);
    assertThat(unit.panTiltState().pan()).isCloseTo(100 * POSITION, within(1e-12));
    assertThat(unit.panTiltState().tilt()).isCloseTo(-50 * POSITION, within(1e-12));
    assertThat(unit.panTiltState().isMoving()).isFalse();
    assertThat(unit.panTiltState().frame()).isEqualTo("atrv1/pan_tilt");
    assertThat(unit.localTransform().x()).isEqualTo(0.2);
    assertThat(unit.localTransform().pitch()).as("down").isCloseTo(50 * POSITION, within(1e-9));
  }

  @Test
  void reportsNothingBeforeTheUnitDoes() {
    assertThatThrownBy(unit::panTiltState)
        .isInstanceOf(NotReadyException.class)
        .hasMessageStartingWith("atrv1/pan_tilt is INITIALIZING");
    assertThatThrownBy(unit::localTransform).isInstanceOf(NotReadyException.class);
    assertThat(unit.attributes()).noneMatch(PanTiltAttributes.class::isInstance);
  }

  @Test
  void pointsTheHeadAndSaysWhileItMoves() throws Exception {
    beReady();
    assertThat(unit.attributes())
        .anySatisfy(
            each -> {
              assertThat(each).isInstanceOf(PanTiltAttributes.class);
              PanTiltAttributes can = (PanTiltAttributes) each;
              assertThat(can.minPan()).isCloseTo(-3090 * POSITION, within(1e-12));
              assertThat(can.maxPan()).isCloseTo(3090 * POSITION, within(1e-12));
              assertThat(can.minTilt()).isCloseTo(-907 * POSITION, within(1e-12));
              assertThat(can.maxTilt()).isCloseTo(604 * POSITION, within(1e-12));
              assertThat(can.maxSpeed()).isCloseTo(2902 * POSITION, within(1e-12));
            });
    try (CommandLease lease = unit.acquireCommandLease(Duration.ofSeconds(10))) {
      unit.execute(lease.key(), new PointAt(1000 * POSITION, -0.3, Math.toRadians(60)));
      // -0.3 rad are -334.2 positions; 60°/s are 1166.7 positions/s.
      assertThat(next()).isEqualTo("PS1167 TS1167 PP1000 TP-334 ");
      say("*\r\n*\r\n*\r\n*\r\n");
      poll(400, -334);
      assertThat(unit.panTiltState().isMoving()).isTrue();
      poll(1000, -334);
      assertThat(unit.panTiltState().isMoving()).isFalse();
      unit.execute(lease.key(), new Halt());
      assertThat(next()).isEqualTo("H ");
      say("*\r\n");
      unit.execute(lease.key(), new PointAt(0, 0, 1000));
      assertThat(next()).as("no faster than it can").isEqualTo("PS2902 TS2902 PP0 TP0 ");
      say("*\r\n*\r\n*\r\n*\r\n");
      unit.execute(lease.key(), new PointAt(0, 0, 1e-9));
      assertThat(next()).as("no slower than it can").isEqualTo("PS31 TS31 PP0 TP0 ");
      say("*\r\n*\r\n*\r\n*\r\n");
    }
    assertThat(next()).as("without a commander it halts").isEqualTo("H ");
  }

  @Test
  void refusesADirectionBeyondTheLimitsByBothSides() throws Exception {
    beReady();
    try (CommandLease lease = unit.acquireCommandLease(Duration.ofSeconds(10))) {
      assertThatThrownBy(() -> unit.execute(lease.key(), new PointAt(3, 0, 1)))
          .isInstanceOf(IllegalArgumentException.class)
          .hasMessage(
              "atrv1/pan_tilt cannot point there: pan of 3.0000 rad is above the limit of 2.7736"
                  + " rad; ask for -2.7736 to 2.7736 rad");
      assertThatThrownBy(() -> unit.execute(lease.key(), new PointAt(0, -1, 1)))
          .hasMessageEndingWith(
              "tilt of -1.0000 rad is below the limit of -0.8141 rad; ask for -0.8141 to 0.5421"
                  + " rad");
      unit.execute(lease.key(), new PointAt(3090 * POSITION + 1e-9, 604 * POSITION, 1));
      assertThat(next()).as("nothing was sent before").endsWith("PP3090 TP604 ");
    }
  }

  @Test
  void noticesThatAReplyWasLostAndTakesNoNumberForAnother() {
    beReady();
    step(100);
    assertThat(next()).isEqualTo("PP ");
    step(1001); // and it is never answered
    awaitWords();
    setUp();
    poll(7, 8);
    assertThat(unit.panTiltState().tilt()).isCloseTo(8 * POSITION, within(1e-12));
    assertThat(unit.readiness()).isEqualTo(Readiness.READY);
    awaitWords();
    assertThat(next()).isEqualTo("PP ");
    say("*\r\n"); // a reply to something else
    awaitWords();
    setUp();
    poll(9, 10);
    assertThat(unit.panTiltState().pan()).isCloseTo(9 * POSITION, within(1e-12));
    assertThat(unit.history().failures()).isZero();
  }

  @Test
  void asksAgainWhenTheUnitReportsWhatCannotBe() {
    answers.put("PX", "-4000");
    awaitWords();
    setUp();
    awaitWords();
    answers.put("PX", "3090");
    answers.put("TR", "many");
    setUp();
    awaitWords();
    answers.put("TR", "185.1428");
    setUp();
    poll(0, 0);
    awaitReadiness(Readiness.READY);
  }

  @Test
  void failsWhenAnAxisRanAgainstItsEndUntilItIsReset() throws Exception {
    beReady();
    say("!T\r\n* 1\r\n");
    awaitReadiness(Readiness.FAILED);
    assertThatThrownBy(unit::panTiltState)
        .hasMessageContaining("the tilt axis ran against its end")
        .hasMessageContaining("reset_by_moving");
    awaitWords();
    setUp();
    poll(1, 1);
    assertThat(unit.readiness()).as("it counts wrong").isEqualTo(Readiness.FAILED);
    CompletableFuture<Diagnosis> recovery =
        CompletableFuture.supplyAsync(() -> unit.recover("reset_by_moving"));
    awaitWords();
    String sent = next();
    while (!sent.equals("R ")) {
      say("* 0\r\n");
      awaitWords();
      sent = next();
    }
    awaitReadiness(Readiness.INITIALIZING);
    say("*\r\n");
    assertThat(recovery.join().passed()).isTrue();
    awaitWords();
    setUp();
    poll(0, 0);
    awaitReadiness(Readiness.READY);
  }

  @Test
  void comesBackWithALinkAndForgetsWhatItHadReceived() {
    beReady();
    ScriptedLink second = links.add();
    link.unplug();
    awaitReadiness(Readiness.INITIALIZING);
    assertThatThrownBy(unit::panTiltState).hasMessageContaining("the device is lost");
    link = second;
    received = 0;
    await()
        .until(
            () -> {
              ticker.step(Duration.ofMillis(100)); // until the link is opened again
              return second.reads() > 0;
            });
    awaitWords();
    setUp();
    poll(5, 5);
    awaitReadiness(Readiness.READY);
    assertThat(unit.history().failures()).isEqualTo(1);
  }

  @Test
  void reopensALinkWhereNoUnitAnswers() {
    beReady();
    await()
        .untilAsserted(
            () -> {
              say("noise\r\n");
              ticker.step(Duration.ofMillis(500));
              assertThatThrownBy(unit::panTiltState).hasMessageEndingWith("no position for 3 s");
            });
    awaitReadiness(Readiness.INITIALIZING);
  }

  @Test
  void countsRefusals() throws Exception {
    beReady();
    try (CommandLease lease = unit.acquireCommandLease(Duration.ofSeconds(10))) {
      unit.execute(lease.key(), new PointAt(0.1, 0, 1));
      next();
      say("*\r\n*\r\n! Maximum allowable Pan position is 3090\r\n*\r\n");
      await().until(() -> parameter(unit, "refused_commands").equals("1"));
    }
  }

  @Test
  void refusesParametersThatAreNone() {
    assertThatThrownBy(() -> driver(Map.of("link", URL, "rate", "50")))
        .isInstanceOf(ConfigurationException.class)
        .hasMessageContaining("parameter rate is \"50\", which is not a number from 0.5 to 20");
    assertThatThrownBy(() -> driver(Map.of())).hasMessageContaining("parameter link is not set");
    beReady();
    assertThatThrownBy(() -> unit.setParameter("rate", "fast"))
        .hasMessageContaining("a number from 0.5 to 20 Hz");
    unit.setParameter("rate", "5");
    assertThat(parameter(unit, "rate")).isEqualTo("5");
  }
}
