package org.dfra.drivers.gps.nmea;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.dfra.drivers.fixture.Modules.awaitReadiness;
import static org.dfra.drivers.fixture.Modules.context;
import static org.dfra.drivers.fixture.Modules.parameter;

import java.time.Duration;
import java.time.Instant;
import java.util.Map;
import org.dfra.core.config.ConfigurationException;
import org.dfra.drivers.fixture.ScriptedLink;
import org.dfra.drivers.fixture.ScriptedLinks;
import org.dfra.drivers.fixture.Sentences;
import org.dfra.drivers.fixture.StepTicker;
import org.dfra.flow.sensor.GpsFix;
import org.dfra.lifecycle.Readiness;
import org.dfra.module.NotReadyException;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/**
 * The driver alone: the test is the receiver and the time. What it shares is in M12PlusLinkTest.
 */
@Timeout(120)
class NmeaImplTest {

  private static final String URL = "tcp://receiver:4001";
  private static final Instant HOST = Instant.parse("2026-11-21T12:00:00.5Z");
  private static final byte[] GGA =
      Sentences.with("GNGGA,120000,4807.038,N,01131.0,E,1,08,0.9,545.4,M,46.9,M,,");
  private static final byte[] RMC =
      Sentences.with("GNRMC,120000,A,4807.038,N,01131.0,E,10.0,84.4,211126,,,A");

  private final StepTicker ticker = new StepTicker(false);
  private final ScriptedLinks links = new ScriptedLinks(URL);
  private final ScriptedLink link = new ScriptedLink(URL);
  private final NmeaImpl gps = driver(Map.of("link", URL, "period", "0.2"));

  @BeforeEach
  void start() {
    links.add(link);
    gps.start();
  }

  @AfterEach
  void end() {
    gps.close();
  }

  @Test
  void servesFixesAndSendsNothing() {
    link.say(GGA);
    link.say(RMC);
    awaitReadiness(gps, Readiness.READY);
    assertThat(gps.fix().mode()).isEqualTo(GpsFix.Mode.FIX_3D);
    assertThat(gps.time().utc()).isEqualTo("2026-11-21T12:00:00Z");
    assertThat(gps.updateRate()).isEqualTo(5);
    assertThat(link.written()).isEmpty();
    assertThat(gps.tests()).containsExactly("link", "positions", "satellites");
    assertThat(gps.recoveries()).containsExactly("reopen_link");
  }

  @Test
  void reopensAReceiverThatIsSilentForThreePeriodsAndTwoSeconds() {
    ScriptedLink second = new ScriptedLink(URL);
    link.say(GGA);
    link.say(RMC);
    awaitReadiness(gps, Readiness.READY);
    links.add(second);
    ticker.step(Duration.ofMillis(2601));
    awaitReadiness(gps, Readiness.INITIALIZING);
    assertThatThrownBy(gps::fix)
        .isInstanceOf(NotReadyException.class)
        .hasMessageEndingWith("no position frame for 2.6 s");
    ticker.awaitWaiting();
    ticker.step(Duration.ofMillis(500));
    second.say(GGA);
    second.say(RMC);
    awaitReadiness(gps, Readiness.READY);
    assertThat(gps.history().failures()).isEqualTo(1);
  }

  @Test
  void correctsADateThatIs1024WeeksTooEarly() {
    link.say(GGA);
    link.say(Sentences.with("GNRMC,120000,A,4807.038,N,01131.0,E,10.0,84.4,070407,,,A"));
    awaitReadiness(gps, Readiness.READY);
    assertThat(gps.time().utc()).isEqualTo("2026-11-21T12:00:00Z");
    assertThat(gps.fix().utc()).isEqualTo("2026-11-21T12:00:00Z");
    assertThat(gps.location().measured()).isEqualTo("2026-11-21T12:00:00Z");
  }

  @Test
  void showsWhatItDropped() {
    link.say(Sentences.bytes("noise"));
    link.say(Sentences.with("GPGGA,25,,,,,1,,,,,,,,"));
    link.say(GGA);
    link.say(RMC);
    awaitReadiness(gps, Readiness.READY);
    assertThat(gps.counts().droppedBytes()).isEqualTo(5);
    assertThat(parameter(gps, "malformed_frames")).isEqualTo("1");
  }

  @Test
  void refusesAPeriodThatIsNone() {
    assertThatThrownBy(() -> driver(Map.of("link", URL, "period", "0")))
        .isInstanceOf(ConfigurationException.class)
        .hasMessageContaining("parameter period is \"0\", which is not a number from 0.02 to 3600");
  }

  private NmeaImpl driver(Map<String, String> texts) {
    return new NmeaImpl(context("gps", texts, () -> HOST), ticker, links);
  }
}
