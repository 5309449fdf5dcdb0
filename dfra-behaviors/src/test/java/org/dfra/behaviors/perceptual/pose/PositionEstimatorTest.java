package org.dfra.behaviors.perceptual.pose;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.time.Duration;
import java.util.Map;
import org.dfra.behaviors.ScriptedRobot;
import org.dfra.behaviors.ScriptedSensors.Receiver;
import org.dfra.behaviors.ScriptedSensors.Wheels;
import org.dfra.core.config.ConfigurationException;
import org.dfra.core.config.Parameters;
import org.dfra.core.config.SourceLocation;
import org.dfra.core.module.ModuleContext;
import org.dfra.flow.perceptual.PoseEstimate;
import org.dfra.flow.sensor.GpsFix;
import org.dfra.lifecycle.Readiness;
import org.dfra.module.NotReadyException;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** The module around the trackers: its parameters, its sources, and what it says without them. */
@Timeout(60)
class PositionEstimatorTest {

  private static final double SPEED = 0.5;

  private final ScriptedRobot robot = new ScriptedRobot();
  private double driven; // metres to the east

  @AfterEach
  void end() {
    robot.close();
  }

  private PositionEstimatorImpl estimator(Map<String, String> parameters) {
    return robot.add(new PositionEstimatorImpl(robot.context("estimator", parameters)));
  }

  /** Drives east for so long. The wheels publish ten times a second, the receivers once. */
  private void drive(double seconds, Wheels wheels, Receiver... receivers) {
    for (int i = 0; i < Math.round(seconds * 10); i++) {
      driven += SPEED * 0.1;
      robot.time.step(0.1);
      count(wheels);
      if (i % 10 == 0) {
        for (Receiver each : receivers) {
          solve(each);
        }
      }
    }
    robot.time.step(0);
  }

  @Test
  void goesOnWithOneReceiverWhenTheOtherDies() {
    Wheels wheels = robot.add(new Wheels(robot.context("odometry", Map.of())));
    Receiver front = robot.add(new Receiver(robot.context("front", Map.of())));
    Receiver rear = robot.add(new Receiver(robot.context("rear", Map.of())));
    PositionEstimatorImpl estimator = estimator(Map.of("gps_bias_sigma", "0", "datum", "48 11"));
    drive(30, wheels, front, rear);
    assertThat(estimator.estimate().east()).isCloseTo(driven, within(0.7));
    robot.end(front);
    drive(30, wheels, rear);
    assertThat(estimator.estimate().east()).isCloseTo(driven, within(0.7));
    assertThat(estimator.estimate().fixAge()).isLessThan(Duration.ofSeconds(3));
    robot.end(rear);
    drive(10, wheels);
    PoseEstimate alone = estimator.estimate();
    assertThat(alone.east()).as("by dead reckoning").isCloseTo(driven, within(1.0));
    assertThat(alone.fixAge()).isGreaterThan(Duration.ofSeconds(8));
    assertThat(estimator.readiness()).isEqualTo(Readiness.READY);
  }

  @Test
  void servesNoLongerWhenTheWheelsFallSilentAndSaysWhatIsMissing() {
    Wheels wheels = robot.add(new Wheels(robot.context("odometry", Map.of())));
    Receiver front = robot.add(new Receiver(robot.context("front", Map.of())));
    PositionEstimatorImpl estimator = estimator(Map.of());
    drive(5, wheels, front);
    assertThat(estimator.estimate()).isNotNull();
    robot.end(wheels);
    robot.time.step(1);
    assertThatThrownBy(estimator::estimate)
        .isInstanceOf(NotReadyException.class)
        .hasMessage(
            "atrv1/estimator is INITIALIZING: no PoseEstimate has come for 0.5 s; there is no"
                + " OdometrySensor on atrv1");
    Wheels again = robot.add(new Wheels(robot.context("odometry", Map.of())));
    robot.time.step(0.1);
    drive(2, again, front);
    assertThat(estimator.estimate()).isNotNull();
  }

  @Test
  void knowsItsFirstYawWhereItIsConfigured() {
    Wheels wheels = robot.add(new Wheels(robot.context("odometry", Map.of())));
    Receiver front = robot.add(new Receiver(robot.context("front", Map.of())));
    PositionEstimatorImpl configured =
        estimator(Map.of("initial_yaw", "1.2", "initial_yaw_sigma", "0.05"));
    PositionEstimatorImpl unconfigured =
        robot.add(new PositionEstimatorImpl(robot.context("unconfigured", Map.of())));
    for (int i = 0; i < 30; i++) { // it stands
      robot.time.step(0.1);
      count(wheels);
      if (i % 10 == 0) {
        solve(front);
      }
    }
    robot.time.step(0);
    assertThat(configured.estimate().yaw()).isCloseTo(1.2, within(0.01));
    assertThat(configured.estimate().yawSigma()).isLessThan(0.1);
    assertThat(unconfigured.estimate().yawSigma()).isGreaterThan(1);
  }

  @Test
  void refusesParametersThatCannotBeWithThePlaceWhereTheyAreWritten() {
    Map<String, String> wrong =
        Map.ofEntries(
            Map.entry("method", "guess"),
            Map.entry("datum", "48 north"),
            Map.entry("gps_white_noise_sigma", "0"),
            Map.entry("gps_bias_correlation_time", "-1"),
            Map.entry("fix_window", "1"),
            Map.entry("position_gate", "0"),
            Map.entry("wheel_slip", "9"),
            Map.entry("gyro_noise_density", "NaN"),
            Map.entry("initial_yaw", "90"),
            Map.entry("initial_yaw_sigma", "0"),
            Map.entry("max_age", "0"));
    wrong.forEach(
        (name, value) -> {
          Parameters parameters =
              new Parameters(
                  "atrv1/estimator",
                  Map.of(name, new Parameters.Value(value, new SourceLocation("atrv1.xml", 12))));
          ModuleContext context = robot.context("estimator", parameters);
          assertThatThrownBy(() -> new PositionEstimatorImpl(context))
              .isInstanceOf(ConfigurationException.class)
              .hasMessageStartingWith(
                  "atrv1.xml:12: atrv1/estimator: parameter %s is \"%s\", which is not "
                      .formatted(name, value));
        });
    assertThatThrownBy(() -> estimator(Map.of("method", "guess")))
        .hasMessageEndingWith("which is not one of kalman, fix_window, raw");
  }

  private void count(Wheels wheels) {
    wheels.count(driven, driven > 0 ? SPEED : 0);
  }

  private void solve(Receiver receiver) {
    receiver.solve(
        new GpsFix(
            GpsFix.Mode.FIX_3D,
            ScriptedRobot.at(driven, 0),
            robot.time.instant(),
            driven > 0 ? SPEED : 0,
            90,
            1,
            9,
            9));
  }
}
