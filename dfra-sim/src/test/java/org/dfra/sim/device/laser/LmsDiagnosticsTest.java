package org.dfra.sim.device.laser;

import static org.assertj.core.api.Assertions.assertThat;
import static org.dfra.sim.device.Modules.await;
import static org.dfra.sim.device.Modules.awaitNoLink;
import static org.dfra.sim.device.Modules.awaitPassed;
import static org.dfra.sim.device.Modules.awaitReadiness;
import static org.dfra.sim.device.Modules.awaitRecovered;
import static org.dfra.sim.device.Modules.failuresButSilence;
import static org.dfra.sim.device.Modules.parameter;

import java.io.IOException;
import java.time.Duration;
import java.time.InstantSource;
import org.dfra.drivers.laser.lms.LmsImpl;
import org.dfra.lifecycle.Readiness;
import org.dfra.module.Diagnosis;
import org.dfra.sim.device.FastClock;
import org.dfra.sim.device.laser.LmsEmulatorSettings.StoredError;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

/** The real driver examines and mends the emulated laser. */
@Timeout(240)
@Execution(ExecutionMode.CONCURRENT) // devices are waited for
class LmsDiagnosticsTest {

  private final InstantSource clock = FastClock.of(Laser.SPEED);
  private final LmsEmulatorSettings makeup = LmsEmulatorSettings.factoryDefault().withBaud(38_400);

  @Test
  void passesItsTestsWhenAllIsWell() throws IOException {
    try (Laser laser = new Laser(makeup, clock);
        LmsImpl driver = laser.driver("idle_timeout", "0")) {
      awaitReadiness(driver, Readiness.READY);
      assertThat(driver.tests()).containsExactly("link", "readings", "status", "type", "errors");
      awaitPassed(driver);
      assertThat(awaitPassed(driver, "status").finding())
          .isEqualTo(
              "software V02.30, laser on, window at 100 % of clean, light at 100 %, severity NONE");
      assertThat(awaitPassed(driver, "type").finding())
          .isEqualTo("it says it is LMS200;30106;V02.30");
      assertThat(awaitPassed(driver, "errors").finding()).isEqualTo("it remembers no errors");
      await("asking disturbs nothing")
          .until(
              () -> {
                long failures = driver.history().failures();
                driver.tests().forEach(driver::test);
                return driver.history().failures() == failures
                    && driver.readiness() == Readiness.READY;
              });
      assertThat(failuresButSilence(driver)).isEmpty();
      assertThat(driver.preconditions()).isNotEmpty();
    }
  }

  @Test
  void asksALaserThatRests() throws IOException {
    try (Laser laser = new Laser(makeup, clock);
        LmsImpl driver = laser.driver("idle_timeout", "0.5")) {
      awaitReadiness(driver, Readiness.READY);
      awaitPassed(driver);
    }
  }

  @Test
  void findsADirtyWindow() throws IOException {
    try (Laser laser = new Laser(makeup.withWindowCleanness(40), clock);
        LmsImpl driver = laser.driver()) {
      awaitReadiness(driver, Readiness.READY);
      Diagnosis status = awaitAnswer(driver, "status", "software ");
      assertThat(status.passed()).isFalse();
      assertThat(status.finding()).contains("window at 40 % of clean").endsWith("window dirty");
      assertThat(parameter(driver, "status")).isEqualTo("severity NONE, window dirty");
    }
  }

  @Test
  void findsErrorsButForThoseThatAreOver() throws IOException {
    try (Laser laser =
            new Laser(makeup.withErrors(new StoredError(2, 21), new StoredError(0x83, 5)), clock);
        LmsImpl driver = laser.driver()) {
      awaitReadiness(driver, Readiness.READY);
      Diagnosis errors = awaitAnswer(driver, "errors", "it remembers ");
      assertThat(errors.passed()).isFalse();
      assertThat(errors.finding())
          .isEqualTo("it remembers error 21 (WARNING), error 5 (ERROR, over)");
      assertThat(awaitAnswer(driver, "status", "software ").passed())
          .as("its severity is WARNING")
          .isFalse();
    }
    try (Laser laser = new Laser(makeup.withErrors(new StoredError(0x83, 5)), clock);
        LmsImpl driver = laser.driver()) {
      awaitReadiness(driver, Readiness.READY);
      awaitPassed(driver, "errors");
    }
  }

  @Test
  void findsASilentLaser() throws IOException {
    try (Laser laser = new Laser(makeup, clock);
        LmsImpl driver = laser.driver()) {
      awaitReadiness(driver, Readiness.READY);
      laser.cable().mute();
      assertThat(driver.test("status").passed()).isFalse();
      laser.cable().unplug();
      awaitReadiness(driver, Readiness.INITIALIZING);
      awaitNoLink(driver);
      await() // it may be open for a moment, see awaitNoLink
          .untilAsserted(
              () ->
                  assertThat(driver.recover("renegotiate").finding())
                      .startsWith("the link is not open: "));
      assertThat(driver.recover("reset").passed()).isFalse();
    }
  }

  @Test
  void reopensTheLink() throws IOException {
    try (Laser laser = new Laser(makeup, clock);
        LmsImpl driver = laser.driver()) {
      awaitReadiness(driver, Readiness.READY);
      awaitRecovered(driver, "reopen_link");
      awaitReadiness(driver, Readiness.READY);
    }
  }

  @Test
  void resetsTheLaserAndConfiguresItAgain() throws IOException {
    try (Laser laser = new Laser(makeup.withWarmUp(Duration.ofSeconds(3)), clock);
        LmsImpl driver = laser.driver("resolution", "1", "baud", "38400")) {
      awaitReadiness(driver, Readiness.READY);
      assertThat(laser.device().baud()).isEqualTo(38_400);
      awaitRecovered(driver, "reset");
      awaitReadiness(driver, Readiness.READY);
      assertThat(Laser.scan(driver).beams()).isEqualTo(181);
      assertThat(laser.device().baud()).isEqualTo(38_400);
      assertThat(laser.device().flashWrites()).as("its flash outlives a reset").isEqualTo(1);
    }
  }

  @Test
  void searchesForTheLaserAgain() throws IOException {
    try (Laser laser = new Laser(makeup, clock);
        LmsImpl driver = laser.driver()) {
      awaitReadiness(driver, Readiness.READY);
      awaitRecovered(driver, "renegotiate");
      awaitReadiness(driver, Readiness.READY);
    }
  }

  /** What a test finds in a laser that answers; by a fast clock it may be too late once. */
  private static Diagnosis awaitAnswer(LmsImpl driver, String test, String begin) {
    return await(test)
        .until(() -> driver.test(test), diagnosis -> diagnosis.finding().startsWith(begin));
  }
}
