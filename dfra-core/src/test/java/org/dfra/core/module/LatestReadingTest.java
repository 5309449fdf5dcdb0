package org.dfra.core.module;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.time.Duration;
import java.time.Instant;
import java.util.Map;
import org.dfra.core.config.Parameters;
import org.dfra.core.lease.SteppedScheduler;
import org.dfra.lifecycle.Readiness;
import org.dfra.module.NotReadyException;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** A reading alone: the test is the device and the time. */
class LatestReadingTest {

  private final SteppedScheduler ticker = new SteppedScheduler();
  private final Thermometer module = new Thermometer(ticker);

  @BeforeEach
  void start() {
    module.start();
  }

  @AfterEach
  void end() {
    module.close();
  }

  @Test
  void saysWhatItAwaitsUntilTheFirstHasCome() {
    assertThatThrownBy(new Thermometer(ticker).latest::get)
        .isInstanceOf(NotReadyException.class)
        .hasMessage("atrv1/thermometer is CREATED: it has not been started");
    assertRefused("INITIALIZING: its link is being opened");
    assertThat(module.latest.peek()).isNull();
    assertThat(module.latest.isTooOld()).as("there is none that could be").isFalse();
    module.latest.set("20 °C");
    assertThat(module.readiness()).isEqualTo(Readiness.READY);
    assertThat(module.latest.get()).isEqualTo("20 °C");
  }

  @Test
  void isWhyItsModuleDoesNotServe() {
    assertThat(module.notReadyReason()).contains("its link is being opened");
    module.latest.set("20 °C");
    assertThat(module.notReadyReason()).isEmpty();
    module.latest.markLost("its cable was pulled");
    assertThat(module.notReadyReason()).contains("its cable was pulled");
  }

  @Test
  void servesNoneThatIsTooOldAsTheAgeIsNow() {
    module.latest.set("20 °C");
    ticker.step(Duration.ofMillis(2500));
    assertThat(module.latest.get()).as("exactly the longest age").isEqualTo("20 °C");
    assertThat(module.latest.isTooOld()).isFalse();
    ticker.step(Duration.ofMillis(1));
    assertRefused(
        "READY: its last temperature is 2.501 s old, and none older than 2.5 s is served");
    assertThat(module.latest.isTooOld()).isTrue();
    assertThat(module.latest.peek()).as("it can be looked at all the same").isEqualTo("20 °C");
    module.longestAge = Duration.ofSeconds(3);
    assertThat(module.latest.get()).as("slower now").isEqualTo("20 °C");
    module.latest.set("21 °C");
    ticker.step(Duration.ofSeconds(3));
    assertThat(module.latest.get()).as("the age is that of the new one").isEqualTo("21 °C");
  }

  @Test
  void isNoYoungerForWhatIsAdded() {
    module.latest.replaceValue("nothing to add to");
    assertThat(module.latest.peek()).isNull();
    module.latest.set("20 °C");
    ticker.step(Duration.ofSeconds(2));
    module.latest.replaceValue("20 °C, humid");
    assertThat(module.latest.get()).isEqualTo("20 °C, humid");
    ticker.step(Duration.ofMillis(501));
    assertThat(module.latest.isTooOld()).isTrue();
  }

  @Test
  void ceasesToServeWhenItIsLostAndServesAgain() {
    module.latest.markLost("the cable is cut");
    assertThat(module.history().failures()).as("it did not serve before").isZero();
    module.latest.set("20 °C");
    module.latest.markLost("the cable is cut again");
    assertRefused("INITIALIZING: the cable is cut again");
    assertThat(module.latest.missing()).isEqualTo("the cable is cut again");
    assertThat(module.history().failures()).isEqualTo(1);
    module.latest.set("21 °C");
    assertThat(module.readiness()).isEqualTo(Readiness.READY);
    assertThat(module.latest.get()).isEqualTo("21 °C");
  }

  @Test
  void leavesTheReadinessAloneWhereItIsForgotten() {
    module.latest.set("20 °C");
    module.latest.clear("the mercury has leaked");
    assertThat(module.readiness()).isEqualTo(Readiness.READY);
    assertRefused("READY: the mercury has leaked");
  }

  @Test
  void servesNoneOfAModuleThatDoesNotServe() {
    module.latest.set("20 °C");
    module.close();
    assertRefused("STOPPED: it has ended");
    module.latest.set("21 °C"); // its reader was late
    assertRefused("STOPPED: it has ended");
  }

  private void assertRefused(String reason) {
    assertThatThrownBy(module.latest::get)
        .isInstanceOf(NotReadyException.class)
        .hasMessage("atrv1/thermometer is " + reason);
  }

  private static final class Thermometer extends ModuleImpl {

    private final LatestReading<String> latest;
    private Duration longestAge = Duration.ofMillis(2500);

    Thermometer(SteppedScheduler ticker) {
      super(
          new ModuleContext(
              "atrv1",
              "thermometer",
              Parameters.of("atrv1/thermometer", Map.of()),
              () -> Instant.parse("2026-11-21T12:00:00Z")),
          "a thermometer",
          "DFRA",
          "1.0");
      this.latest =
          new LatestReading<>(
              "temperature", this, this::transitionTo, ticker::nanos, () -> longestAge);
    }

    @Override
    protected void onStart() {
      latest.setMissing("its link is being opened");
    }

    @Override
    protected void onClose() {
      latest.clear("it has ended");
    }
  }
}
