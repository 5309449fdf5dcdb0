package org.dfra.drivers.gyro.kvh;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;
import static org.dfra.drivers.fixture.Modules.await;
import static org.dfra.drivers.fixture.Modules.context;
import static org.dfra.drivers.fixture.Modules.parameter;

import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.time.Instant;
import java.util.Locale;
import java.util.Map;
import java.util.Random;
import java.util.concurrent.CompletableFuture;
import java.util.function.DoubleSupplier;
import org.dfra.core.config.ConfigurationException;
import org.dfra.drivers.fixture.Modules;
import org.dfra.drivers.fixture.ScriptedLink;
import org.dfra.drivers.fixture.ScriptedLinks;
import org.dfra.drivers.fixture.StepTicker;
import org.dfra.lifecycle.Readiness;
import org.dfra.module.Diagnosis;
import org.dfra.module.NotReadyException;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** The driver alone: the test is the gyro and the time. */
@Timeout(120)
class Dsp3000ImplTest {

  private static final String URL = "tcp://gyro:4001";
  private static final Instant NOW = Instant.parse("2026-11-21T12:00:00Z");

  private final StepTicker ticker = new StepTicker(false);
  private final ScriptedLinks links = new ScriptedLinks(URL);
  private ScriptedLink link = new ScriptedLink(URL);
  private final Dsp3000Impl gyro = driver(Map.of("link", URL));

  @BeforeEach
  void start() {
    links.add(link);
    gyro.start();
  }

  @AfterEach
  void end() {
    gyro.close();
  }

  @Test
  void setsTheModeAndReportsRatesThatArePositiveToTheLeft() {
    send(Dsp3000Impl.TRUSTED, 0, true);
    awaitReadiness(Readiness.READY);
    assertThat(new String(link.written().get(0), StandardCharsets.US_ASCII)).isEqualTo("RRR");
    send(1, -90, true);
    assertThat(gyro.rate().rate()).isCloseTo(Math.PI / 2, within(1e-9));
    assertThat(gyro.rate().frame()).isEqualTo("atrv1/gyro");
    assertThat(gyro.updateRate()).isEqualTo(100);
    gyro.setParameter("inverted", "true");
    send(1, -90, true);
    assertThat(gyro.rate().rate()).isCloseTo(-Math.PI / 2, within(1e-9));
    gyro.setParameter("bias", "0.02");
    send(1, 0, true);
    assertThat(gyro.rate().rate()).isCloseTo(-0.02, within(1e-12));
  }

  @Test
  void isNotReadyWhileTheGyroDoesNotVouchForItself() {
    send(50, 0, false);
    assertThat(gyro.readiness()).isEqualTo(Readiness.INITIALIZING);
    assertThatThrownBy(gyro::rate)
        .isInstanceOf(NotReadyException.class)
        .hasMessageEndingWith("the gyro says that its rate is not valid");
    send(Dsp3000Impl.TRUSTED - 1, 0, true);
    assertThat(gyro.readiness()).as("too few in a row").isEqualTo(Readiness.INITIALIZING);
    send(1, 0, true);
    awaitReadiness(Readiness.READY);
    send(1, 0, false);
    awaitReadiness(Readiness.INITIALIZING);
    assertThatThrownBy(gyro::rate).isInstanceOf(NotReadyException.class);
    assertThat(gyro.history().failures()).isEqualTo(1);
    send(Dsp3000Impl.TRUSTED, 0, true);
    awaitReadiness(Readiness.READY);
  }

  @Test
  void servesNothingOldAndReopensASilentLink() {
    send(Dsp3000Impl.TRUSTED, 5, true);
    awaitReadiness(Readiness.READY);
    ticker.step(Duration.ofMillis(501));
    assertThatThrownBy(gyro::rate)
        .hasMessageEndingWith("its last rate is 0.501 s old, and none older than 0.5 s is served");
    ScriptedLink second = links.add();
    ticker.step(Duration.ofMillis(1500));
    awaitReadiness(Readiness.INITIALIZING);
    assertThatThrownBy(gyro::rate).hasMessageEndingWith("no line for 2 s");
    link = second;
    await()
        .until(
            () -> {
              ticker.step(Duration.ofMillis(100));
              return second.reads() > 0;
            });
    send(Dsp3000Impl.TRUSTED, 5, true);
    awaitReadiness(Readiness.READY);
  }

  @Test
  void takesTheMeanForTheBiasWhileItStands() {
    long seed = Long.getLong("dfra.seed", new Random().nextLong());
    Random random = new Random(seed);
    send(Dsp3000Impl.TRUSTED, 0.2, true);
    awaitReadiness(Readiness.READY);
    Diagnosis zeroed = zero(() -> 0.2 + 0.05 * random.nextGaussian());
    assertThat(zeroed.passed()).as("-Ddfra.seed=%d: %s", seed, zeroed).isTrue();
    // The mean of 500 with a deviation of 0.05 °/s is off by 0.0022 °/s; six times that never.
    assertThat(Double.parseDouble(parameter(gyro, "bias")))
        .as("-Ddfra.seed=%d", seed)
        .isCloseTo(Math.toRadians(-0.2), within(Math.toRadians(0.0135)));
    send(1, 0.2, true);
    assertThat(gyro.rate().rate()).isCloseTo(0, within(Math.toRadians(0.0135)));
  }

  @Test
  void refusesABiasOfAGyroThatTurns() {
    send(Dsp3000Impl.TRUSTED, 0, true);
    awaitReadiness(Readiness.READY);
    int[] count = {0};
    assertThat(zero(() -> count[0]++ % 2 == 0 ? 10 : -10).finding())
        .startsWith("it is moving: its rates differ by 10.000 °/s > 0.500 °/s");
    assertThat(zero(() -> 5).finding())
        .startsWith("it is moving: it turns by -5.000 °/s, and no bias is greater than 1.000");
    assertThat(parameter(gyro, "bias")).isEqualTo("0");
  }

  @Test
  void findsNoBiasWithoutValidRates() {
    send(50, 0, false);
    assertThat(gyro.recover("calibrate_bias_while_stationary").finding())
        .isEqualTo("it reports no valid rate: the gyro says that its rate is not valid");
  }

  @Test
  void refusesParametersThatAreNone() {
    assertThatThrownBy(() -> driver(Map.of("link", URL, "inverted", "yes")))
        .isInstanceOf(ConfigurationException.class)
        .hasMessageContaining("parameter inverted is \"yes\", which is not true or false");
    assertThatThrownBy(() -> driver(Map.of("link", URL, "bias", "5")))
        .hasMessageContaining("parameter bias is \"5\", which is not a number from -0.1 to 0.1");
    assertThatThrownBy(() -> gyro.setParameter("inverted", "1"))
        .hasMessageContaining("which is not true or false");
  }

  private Diagnosis zero(DoubleSupplier rates) {
    CompletableFuture<Diagnosis> zeroed =
        CompletableFuture.supplyAsync(() -> gyro.recover("calibrate_bias_while_stationary"));
    while (!zeroed.isDone()) {
      send(1, rates.getAsDouble(), true);
    }
    return zeroed.join();
  }

  /** Sends so many lines, and waits until the driver has read them. */
  private void send(int times, double rate, boolean isValid) {
    String line = String.format(Locale.ROOT, "\n%.6f %d\r", rate, isValid ? 1 : 0);
    for (int i = 0; i < times; i++) {
      link.say(line.getBytes(StandardCharsets.US_ASCII));
    }
    link.awaitLooked();
  }

  private void awaitReadiness(Readiness expected) {
    Modules.awaitReadiness(gyro, expected);
  }

  private Dsp3000Impl driver(Map<String, String> texts) {
    return new Dsp3000Impl(context("gyro", texts, () -> NOW), ticker, links);
  }
}
