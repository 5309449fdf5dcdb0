package org.dfra.drivers.gps.m12;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.dfra.drivers.fixture.Modules.await;
import static org.dfra.drivers.fixture.Modules.parameter;
import static org.dfra.lifecycle.Readiness.INITIALIZING;

import java.time.Duration;
import java.time.Instant;
import java.time.LocalDateTime;
import java.util.HashMap;
import java.util.Map;
import org.dfra.core.config.ConfigurationException;
import org.dfra.drivers.fixture.Frames;
import org.dfra.drivers.fixture.ScriptedLink;
import org.dfra.drivers.gps.m12.M12Message.PositionControl;
import org.dfra.drivers.gps.m12.M12Message.PositionHoldMode;
import org.dfra.flow.sensor.GpsFix;
import org.dfra.flow.sensor.TimeReading;
import org.dfra.geometry.GeoPosition;
import org.dfra.lifecycle.Readiness;
import org.dfra.module.NotReadyException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** What the driver asks its receiver for, and what it makes of the answers. */
class M12PlusImplTest extends ScriptedM12 {

  @Test
  void asksWhatItIsSetsItToASafeStateAndOrdersWhatItWants() {
    gps.start();
    await().until(() -> link.written().size() == ORDERS);
    assertThat(link.written())
        .containsExactly(
            M12Commands.identification(),
            M12Commands.utcTime(),
            M12Commands.positionControl(PositionControl.Mode.POSITION_3D),
            M12Commands.positionOf12Channels(1),
            M12Commands.timeRaimOn(),
            M12Commands.timeRaimOf12Channels(1),
            M12Commands.visibleSatellites(true),
            M12Commands.utcOffset(),
            M12Commands.askHoldPosition());
  }

  @Test
  void repeatsWhatIsNotAcknowledgedAndThenSaysSo() {
    gps.start();
    link.say(FIX);
    awaitReadiness(Readiness.READY);
    link.say(M12Commands.utcTime());
    link.say(M12Commands.timeRaimOn());
    await().until(() -> gps.counts().frames() == 3);
    for (int tries = 1; tries < 3; tries++) {
      ticker.step(Duration.ofSeconds(3).plusNanos(1));
      link.say(FIX);
      int expected = ORDERS + tries;
      await().until(() -> link.written().size() == expected);
      assertThat(link.written().get(expected - 1))
          .isEqualTo(M12Commands.positionControl(PositionControl.Mode.POSITION_3D));
    }
    ticker.step(Duration.ofSeconds(3).plusNanos(1));
    link.say(FIX);
    await()
        .untilAsserted(
            () ->
                assertThat(warnings())
                    .containsExactly(
                        "atrv1/gps_front: the receiver has not acknowledged @@Gd, which it"
                            + " should"));
    assertThat(link.written()).hasSize(ORDERS + 2);
  }

  @Test
  void setsWhatTheReceiverSolvesForWhileItRuns() {
    gps.start();
    await().until(() -> link.written().size() == ORDERS);
    assertThatThrownBy(() -> gps.setParameter("positioning", "guess"))
        .hasMessageContaining(
            "cannot be \"guess\", which is not position_3d, altitude_hold, hold or survey");
    gps.setParameter("positioning", "altitude_hold");
    await().until(() -> link.written().size() == ORDERS + 1);
    assertThat(link.written().get(ORDERS))
        .isEqualTo(M12Commands.positionControl(PositionControl.Mode.ALTITUDE_HOLD));
  }

  @Test
  void shortPositionsKnowUtcByOtherMessages() {
    ScriptedLink brief = new ScriptedLink(URL);
    links.clear();
    links.add(brief);
    try (M12PlusImpl driver = driver(Map.of("link", URL, "position_message", "short"))) {
      driver.start();
      brief.say(Frames.hb(TIME, 52.91, 6.86, Frames.FIX_3D));
      await().until(() -> driver.readiness() == Readiness.READY);
      assertThat(brief.written()).contains(M12Commands.shortPosition(1));
      assertThat(driver.fix().position()).isEqualTo(new GeoPosition(52.91, 6.86, 0));
      assertThatThrownBy(driver::time).hasMessageContaining("has not yet learned");
      brief.say(M12Commands.utcTime());
      brief.say(M12Commands.encode("Bo", 18));
      brief.say(Frames.hb(TIME, 52.91, 6.86, Frames.FIX_3D));
      await().until(() -> driver.counts().frames() == 4);
      await()
          .untilAsserted(() -> assertThat(driver.time().utc()).isEqualTo("2026-01-21T07:33:29Z"));
      assertThat(parameter(driver, "utc_offset")).isEqualTo("18");
    }
  }

  @Test
  void showsSatellitesAndIntegrity() {
    gps.start();
    assertThat(parameter(gps, "integrity")).isEqualTo("not reported");
    byte[] fix = Frames.with(FIX, 57, 14 << 24 | 8 << 16 | 47 << 8, 4);
    link.say(Frames.with(fix, 63, 23 << 24 | 1 << 16, 4));
    int[] visible = new int[85];
    visible[0] = 2;
    System.arraycopy(new int[] {14, 0, 0, 41, 0, 60, 0}, 0, visible, 1, 7);
    System.arraycopy(new int[] {9, 0, 0, 5, 1, 4, 0}, 0, visible, 8, 7);
    link.say(M12Commands.encode("Bb", visible));
    int[] raim = new int[71];
    raim[2] = 1; // alarm
    raim[9] = 54;
    link.say(M12Commands.encode("Hn", raim));
    await().until(() -> gps.counts().frames() == 3);
    await()
        .untilAsserted(
            () ->
                assertThat(parameter(gps, "satellites"))
                    .isEqualTo(
                        "3 in view, 1 tracked, 1 used: G14 41° up, 60° from north, 47 dB-Hz, used;"
                            + " G23 not tracked; G09 5° up, 260° from north, not tracked"));
    assertThat(gps.test("integrity").finding())
        .isEqualTo(
            "ALARM, a wrong satellite would be detected and taken out, time accurate to 54 ns");
    assertThat(gps.test("integrity").passed()).isFalse();
    assertThat(gps.test("satellites").passed()).as("one is too few").isFalse();
  }

  @Test
  void becomesReadyWithTheFirstPosition() {
    assertThat(gps.readiness()).isEqualTo(Readiness.CREATED);
    gps.start();
    link.say(NO_FIX);
    await().until(() -> gps.counts().frames() == 1);
    assertThat(gps.readiness()).isEqualTo(Readiness.INITIALIZING);
    link.say(FIX);
    awaitReadiness(Readiness.READY);
    assertThat(gps.fix().mode()).isEqualTo(GpsFix.Mode.FIX_3D);
    assertThat(gps.location().position()).isEqualTo(new GeoPosition(52.91, 6.86, 0));
    assertThat(gps.location().frame()).isEqualTo("atrv1/gps_front");
    assertThat(gps.location().measured()).isEqualTo("2026-01-21T07:33:29Z");
    assertThat(gps.time()).isEqualTo(new TimeReading(Instant.parse("2026-01-21T07:33:29Z"), HOST));
    assertThat(gps.time().hostOffset()).isEqualTo(Duration.ofMillis(400));
    assertThat(gps.updateRate()).isEqualTo(1);
  }

  @Test
  void saysWhatItWaitsForBeforeTheFirstPosition() {
    assertRefuses(gps::fix, "atrv1/gps_front is CREATED: it has not been started");
    gps.start();
    await().until(() -> !link.written().isEmpty());
    assertRefuses(
        gps::location,
        "atrv1/gps_front is INITIALIZING: " + URL + " is open, no position frame has come yet");
    link.say(NO_FIX);
    await().until(() -> gps.counts().frames() == 1);
    await()
        .untilAsserted(
            () ->
                assertRefuses(
                    gps::time,
                    "atrv1/gps_front is INITIALIZING: the receiver has no position yet, it is"
                        + " acquiring satellites, 0 of 0 tracked"));
    gps.close();
    assertRefuses(gps::fix, "atrv1/gps_front is STOPPED: it has ended");
  }

  @ParameterizedTest
  @ValueSource(booleans = {true, false})
  void correctsADateThatIs1024WeeksTooEarly(boolean hasTwelveChannels) {
    LocalDateTime early = TIME.minusWeeks(1024);
    gps.start();
    link.say(M12Commands.utcTime()); // so that eight channels report UTC
    link.say(M12Commands.encode("Bo", 18));
    link.say(
        hasTwelveChannels
            ? Frames.ha(early, 52.91, 6.86, Frames.FIX_3D)
            : Frames.ea(early, 57.71, 12.02, 0x20));
    awaitReadiness(Readiness.READY);
    assertThat(gps.fix().utc()).isEqualTo("2026-01-21T07:33:29Z");
    assertThat(gps.time().utc()).isEqualTo("2026-01-21T07:33:29Z");
    assertThat(gps.location().measured()).isEqualTo("2026-01-21T07:33:29Z");
  }

  @Test
  void reportsNoTimeBeforeItKnowsUtc() {
    gps.start();
    link.say(Frames.with(FIX, 141, 0x80, 1));
    awaitReadiness(Readiness.READY);
    assertThat(gps.location().position().latitude()).isEqualTo(52.91);
    assertThatThrownBy(gps::time)
        .isInstanceOf(NotReadyException.class)
        .hasMessageContaining("has not yet learned from the satellites");
  }

  @Test
  void asksAnEightChannelReceiverForWhatItHas() {
    gps.start();
    await().until(() -> link.written().size() == ORDERS);
    ticker.step(Duration.ofSeconds(2).plusNanos(1));
    await().until(() -> link.written().size() == ORDERS + 3);
    assertThat(link.written().subList(ORDERS, ORDERS + 3))
        .containsExactly(
            M12Commands.positionHold(PositionHoldMode.Mode.OFF),
            M12Commands.positionOf8Channels(1),
            M12Commands.timeRaimOf8Channels(1));
    link.say(Frames.ea(TIME, 57.71, 12.02, 0x20));
    awaitReadiness(Readiness.READY);
    assertThat(gps.fix().position()).isEqualTo(new GeoPosition(57.71, 12.02, 0));
    await().until(() -> Integer.valueOf(8).equals(gps.receiver().channels()));
  }

  @Test
  void eightChannelsReportNoTimeBeforeTheOffsetOfUtcIsKnown() {
    LocalDateTime gpsTime = TIME.plusSeconds(18); // what the receiver shows until it knows better
    gps.start();
    link.say(M12Commands.utcTime());
    link.say(M12Commands.encode("Bo", 0));
    link.say(Frames.ea(gpsTime, 57.71, 12.02, 0x20));
    awaitReadiness(Readiness.READY);
    assertThat(gps.fix().position()).isEqualTo(new GeoPosition(57.71, 12.02, 0));
    assertThat(gps.fix().utc()).as("the host's, not GPS time").isEqualTo(HOST);
    assertRefuses(
        gps::time,
        "atrv1/gps_front is READY: the receiver has positions, but has not yet learned from the"
            + " satellites how far GPS time is ahead of UTC; after a cold start that takes up to"
            + " 12.5 minutes");
    link.say(M12Commands.encode("Bo", 18));
    link.say(Frames.ea(TIME.plusSeconds(1), 57.71, 12.02, 0x20));
    await().until(() -> gps.counts().frames() == 5);
    await().untilAsserted(() -> assertThat(gps.time().utc()).isEqualTo("2026-01-21T07:33:30Z"));
    assertThat(gps.fix().utc()).isEqualTo("2026-01-21T07:33:30Z");
  }

  @Test
  void eightChannelsReportNoTimeBeforeTheyConfirmUtc() {
    gps.start();
    link.say(M12Commands.encode("Bo", 18));
    link.say(Frames.ea(TIME, 57.71, 12.02, 0x20));
    awaitReadiness(Readiness.READY);
    assertRefuses(
        gps::time,
        "atrv1/gps_front is READY: the receiver has positions, but has not yet confirmed (@@Aw)"
            + " that it reports UTC and not GPS time");
  }

  @Test
  void servesThePositionThatAnEightChannelReceiverHolds() {
    byte[] held = Frames.with(Frames.ea(TIME, 57.71, 12.02, 0x08), 39, 6, 1);
    gps.setParameter("positioning", "hold");
    gps.start();
    await().until(() -> link.written().size() == ORDERS);
    ticker.step(Duration.ofSeconds(2).plusNanos(1));
    await().until(() -> link.written().size() == ORDERS + 3);
    assertThat(link.written().get(ORDERS))
        .isEqualTo(M12Commands.positionHold(PositionHoldMode.Mode.ON));
    link.say(held);
    await().until(() -> gps.counts().frames() == 1);
    assertThat(gps.readiness()).as("acquiring, as far as is known").isEqualTo(INITIALIZING);
    link.say(M12Commands.positionHold(PositionHoldMode.Mode.ON)); // acknowledges
    link.say(held);
    awaitReadiness(Readiness.READY);
    assertThat(gps.fix().mode()).isEqualTo(GpsFix.Mode.POSITION_HOLD);
    assertThat(gps.fix().position()).isEqualTo(new GeoPosition(57.71, 12.02, 0));
    gps.setParameter("positioning", "position_3d");
    await().until(() -> link.written().size() == ORDERS + 5);
    assertThat(link.written().get(ORDERS + 4))
        .isEqualTo(M12Commands.positionHold(PositionHoldMode.Mode.OFF));
    link.say(M12Commands.positionHold(PositionHoldMode.Mode.OFF));
    link.say(held);
    await().until(() -> gps.fix().mode() == GpsFix.Mode.NONE);
  }

  @Test
  void asksWhetherASurveyHasEnded() {
    byte[] held = Frames.with(Frames.ea(TIME, 57.71, 12.02, 0x08), 39, 6, 1);
    gps.start();
    await().until(() -> link.written().size() == ORDERS);
    link.say(M12Commands.positionHold(PositionHoldMode.Mode.SURVEY));
    link.say(held);
    await().until(() -> link.written().size() == ORDERS + 1);
    assertThat(link.written().get(ORDERS)).isEqualTo(M12Commands.askPositionHold());
    assertThat(gps.readiness()).isEqualTo(INITIALIZING);
    link.say(M12Commands.positionHold(PositionHoldMode.Mode.ON));
    link.say(held);
    awaitReadiness(Readiness.READY);
  }

  @Test
  void aReceiverThatSearchesHoldsNothing() {
    gps.start();
    link.say(M12Commands.positionHold(PositionHoldMode.Mode.ON));
    link.say(Frames.ea(TIME, 57.71, 12.02, 0x0A)); // nothing tracked, fewer than 3 visible
    link.say(Frames.ea(TIME, 57.71, 12.02, 0x88)); // propagated
    await().until(() -> gps.counts().frames() == 3);
    assertThat(gps.readiness()).isEqualTo(INITIALIZING);
    link.say(Frames.ea(TIME, 57.71, 12.02, 0x08));
    awaitReadiness(Readiness.READY);
    assertThat(gps.fix().mode()).isEqualTo(GpsFix.Mode.POSITION_HOLD);
    assertThatThrownBy(gps::time).hasMessageContaining("tracks no satellite");
  }

  @Test
  void prefersTwelveChannelsToEightAndStopsTheEight() {
    gps.start();
    await().until(() -> link.written().size() == ORDERS);
    ticker.step(Duration.ofSeconds(2).plusNanos(1));
    await().until(() -> link.written().size() == ORDERS + 3);
    link.say(FIX);
    await().until(() -> link.written().size() == ORDERS + 5);
    assertThat(link.written().get(ORDERS + 3)).isEqualTo(M12Commands.positionOf8Channels(0));
    link.say(Frames.ea(TIME, 57.71, 12.02, 0x20));
    await().until(() -> gps.counts().frames() == 2);
    assertThat(gps.fix().position()).isEqualTo(new GeoPosition(52.91, 6.86, 0));
    assertThat(gps.receiver().channels()).isEqualTo(12);
  }

  @Test
  void remembersWhatTheReceiverIs() {
    assertThat(gps.identified()).isEmpty();
    gps.start();
    int[] payload = new int[287];
    for (int i = 0; i < payload.length; i++) {
      payload[i] = i < 13 ? "MODEL #  P283".charAt(i) : ' ';
    }
    link.say(M12Commands.encode("Cj", payload));
    await().until(() -> gps.identified().isPresent());
    assertThat(gps.identified().orElseThrow().model()).isEqualTo("P283");
    assertThat(gps.identification().description()).contains("M12+");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "link | | parameter link is not set",
        "link | udp://x:1 | parameter link is \"udp://x:1\", which is not a usable link: link",
        "period | 0 | parameter period is \"0\", which is not a number from 1 to 255",
        "positioning | fast | parameter positioning is \"fast\", which is not position_3d, altitude_hold",
        "position_message | none | parameter position_message is \"none\", which is not full or short",
        "period | 1.5 | parameter period is \"1.5\", which is not a whole number of seconds",
        "reopen_initial_delay | 9 | parameter reopen_initial_delay is \"9\", which is not in order: reopen_initial_delay is",
      })
  void refusesWrongParametersWithTheirPlace(String name, String value, String sentence) {
    Map<String, String> texts = new HashMap<>(Map.of("link", URL));
    texts.put(name, value);
    texts.values().removeIf(text -> text == null);
    assertThatThrownBy(() -> driver(texts))
        .isInstanceOf(ConfigurationException.class)
        .hasMessageContaining("atrv1/gps_front: " + sentence);
  }
}
