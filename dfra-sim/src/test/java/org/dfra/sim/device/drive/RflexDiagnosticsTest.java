package org.dfra.sim.device.drive;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.time.Duration;
import java.util.Map;
import org.dfra.core.config.ConfigurationException;
import org.dfra.core.module.ModuleImpl;
import org.dfra.drivers.drive.rflex.RflexBatteryImpl;
import org.dfra.drivers.drive.rflex.RflexDriveImpl;
import org.dfra.flow.effector.CommandKey;
import org.dfra.flow.effector.CommandLease;
import org.dfra.flow.effector.DriveCommand.Velocity;
import org.dfra.lifecycle.Readiness;
import org.dfra.module.Diagnosis;
import org.dfra.module.NotReadyException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The three drivers examine and mend their controller, and say what they refuse and why. */
class RflexDiagnosticsTest extends RflexInLockStep {

  @Test
  void passesItsTestsWhenAllIsWellWithoutMoving() {
    startAll();
    wheels.orders.clear();
    for (ModuleImpl each : new ModuleImpl[] {drive, odometry, battery}) {
      org.dfra.core.module.DeviceImpl module = (org.dfra.core.module.DeviceImpl) each;
      for (String test : module.tests()) {
        Diagnosis diagnosis = module.test(test);
        assertThat(diagnosis.passed()).as("%s of %s", diagnosis, each).isTrue();
      }
    }
    assertThat(drive.tests()).containsExactly("link", "readings", "brake", "voltage");
    assertThat(odometry.tests()).containsExactly("link", "readings");
    assertThat(battery.tests()).containsExactly("link", "readings", "voltage");
    assertThat(drive.test("brake").finding()).isEqualTo("the brake is set");
    assertThat(battery.test("voltage").finding()).isEqualTo("25.20 V");
    assertThat(wheels.orders).isEmpty();
  }

  @Test
  void failsItsTestsWhenTheyShould() {
    startAll();
    voltage = 21;
    assertThat(battery.test("voltage").finding())
        .isEqualTo("21.00 V, less than 23.00 V; charge the battery");
    port.cable().mute();
    assertThat(drive.test("readings").finding()).isEqualTo("no report has come within 3 s");
    port.cable().unplug();
    comesTo(drive, Readiness.INITIALIZING);
    for (String test : drive.tests()) {
      Diagnosis diagnosis = drive.test(test);
      assertThat(diagnosis.passed()).as("%s", diagnosis).isFalse();
      assertThat(diagnosis.finding()).startsWith("the link is not open: ");
    }
    assertThat(drive.recover("reset_defaults").passed()).isFalse();
    assertThat(drive.recover("reopen_link").passed()).isFalse();
    drive.close();
    assertThat(drive.test("link").finding())
        .isEqualTo("the module has not been started, or has ended");
  }

  @Test
  void recoversWithoutMoving() throws Exception {
    startAll();
    assertThat(drive.recoveries()).containsExactly("reopen_link", "reset_defaults");
    for (String recovery : drive.recoveries()) {
      Diagnosis done = drive.recover(recovery);
      assertThat(done.passed()).as("%s", done).isTrue();
      comesTo(drive, Readiness.READY);
    }
    assertThat(drive.driveState().parkingBrakeEngaged())
        .as("no recovery releases the brake")
        .isTrue();
    assertThat(wheels.travel(time.instant()).distance()).isZero();
    CommandKey key = commander();
    driveOn(key, new Velocity(0.5, 0), Duration.ofSeconds(1));
    assertThat(drive.recover("reset_defaults").finding())
        .isEqualTo("the wheels turn, or are not known to be stopped; halt them first");
  }

  @Test
  void saysWhyItDoesNotExecuteCommands() throws Exception {
    port.cable().unplug();
    drive.start();
    CommandLease lease = drive.acquireCommandLease(Duration.ofSeconds(30));
    time.advance(Duration.ofSeconds(1));
    assertThatThrownBy(() -> drive.execute(lease.key(), Velocity.ZERO))
        .isInstanceOf(NotReadyException.class)
        .hasMessageContaining(
            "now: sim:rflex: the cable of this simulated device is pulled out (if another process"
                + " has it: modules that share a controller must be in one group)");
    assertThatThrownBy(odometry::odometry)
        .hasMessage("atrv1/odometry is CREATED: it has not been started");
  }

  @Test
  void refusesAnotherNameForTheSamePort() {
    RflexBatteryImpl first =
        new RflexBatteryImpl(context("first", Map.of("link", "serial:/dev/ttyNone?baud=115200")));
    RflexBatteryImpl second =
        new RflexBatteryImpl(context("second", Map.of("link", "serial:/dev/ttyNone?baud=9600")));
    try (first;
        second) {
      first.start();
      assertThatThrownBy(second::start)
          .isInstanceOf(ConfigurationException.class)
          .hasMessageContaining(
              "atrv1/second: parameter link is \"serial:/dev/ttyNone?baud=9600\", which is not"
                  + " \"serial:/dev/ttyNone?baud=115200\" as atrv1/first has it");
    }
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "units_per_metre | 5 | units_per_metre is \"5\", which is not 1000 to 1000000 counts either",
        "units_per_radian | east | units_per_radian is \"east\", which is not a number from",
        "stop_deceleration | 2 | \"2\", which is not enough to stop in time: 2.39 m/s² or more",
        "stop_yaw_deceleration | 4 | not enough to stop in time: 4.77 rad/s² or more",
        "command_timeout | 0.4 | \"0.4\", which is not a number from 0.05 to 0.327",
        "link | rflex | parameter link is \"rflex\", which is not a usable link",
      })
  void refusesParametersThatCannotBe(String name, String text, String sentence) {
    assertThatThrownBy(() -> new RflexDriveImpl(context("drive", Map.of(name, text))))
        .isInstanceOf(ConfigurationException.class)
        .hasMessageContaining(sentence);
  }

  @ParameterizedTest
  @CsvSource({"23.6:0", "24:0 23:1", "24:0 25:2", "24:0 25", "24:0.5 25:0.25", "full"})
  void refusesCurvesThatAreNone(String curve) {
    assertThatThrownBy(() -> battery.setParameter("charge_curve", curve))
        .hasMessageContaining("which is not a curve like");
    assertThatThrownBy(
            () -> new RflexBatteryImpl(context("battery", Map.of("charge_curve", curve))))
        .isInstanceOf(ConfigurationException.class)
        .hasMessageContaining("which is not a curve like");
  }
}
