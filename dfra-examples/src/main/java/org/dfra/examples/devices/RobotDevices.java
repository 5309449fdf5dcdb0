package org.dfra.examples.devices;

import java.util.ArrayList;
import java.util.List;
import org.dfra.directory.Condition;
import org.dfra.directory.ModuleDirectory;
import org.dfra.directory.ModuleListing;
import org.dfra.directory.ModuleQuery;
import org.dfra.flow.effector.DriveEffector;
import org.dfra.flow.effector.PanTiltEffector;
import org.dfra.flow.sensor.AngularRateSensor;
import org.dfra.flow.sensor.BatterySensor;
import org.dfra.flow.sensor.CameraImage.Band;
import org.dfra.flow.sensor.CameraSensor;
import org.dfra.flow.sensor.GPSSensor;
import org.dfra.flow.sensor.OdometrySensor;
import org.dfra.flow.sensor.RangeSensor;
import org.dfra.module.Module;
import org.dfra.persona.CameraAttributes;
import org.dfra.persona.DriveAttributes;
import org.dfra.persona.PanTiltAttributes;
import org.dfra.persona.RangeAttributes;
import org.dfra.persona.SensorAttributes;

/** The robot's devices that the demonstration needs, queried by capability and never by name. */
final class RobotDevices {

  /** All queries, in the order in which they are printed. */
  private final List<Question<?>> questions = new ArrayList<>();

  private final ModuleDirectory directory;

  /**
   * A query for one device.
   *
   * @param need what is needed, in words
   */
  record Question<M extends Module>(String need, ModuleQuery<M> query) {}

  final Question<DriveEffector> drive =
      ask(
          "a drive of 0.5 m/s or faster",
          ModuleQuery.of(DriveEffector.class)
              .where(DriveAttributes.class, "maxSpeed", Condition.atLeast(0.5)));

  final Question<OdometrySensor> odometry =
      ask(
          "odometry, 5 Hz or more",
          ModuleQuery.of(OdometrySensor.class)
              .where(SensorAttributes.class, "maxRate", Condition.atLeast(5)));

  final Question<GPSSensor> gps =
      ask(
          "a satellite receiver, 1 Hz or more",
          ModuleQuery.of(GPSSensor.class)
              .where(SensorAttributes.class, "maxRate", Condition.atLeast(1)));

  final Question<RangeSensor> laser =
      ask(
          "ranges to 8 m or farther, over the whole front",
          ModuleQuery.of(RangeSensor.class)
              .where(RangeAttributes.class, "maxRange", Condition.atLeast(8))
              .where(RangeAttributes.class, "fieldOfView", Condition.atLeast(Math.PI - 0.01)));

  final Question<AngularRateSensor> gyro =
      ask(
          "a gyro, 50 Hz or more",
          ModuleQuery.of(AngularRateSensor.class)
              .where(SensorAttributes.class, "maxRate", Condition.atLeast(50)));

  final Question<PanTiltEffector> panTilt =
      ask(
          "a pan-tilt unit that turns 45° to the left",
          ModuleQuery.of(PanTiltEffector.class)
              .where(PanTiltAttributes.class, "maxPan", Condition.atLeast(Math.PI / 4)));

  final Question<CameraSensor> camera =
      ask(
          "a visible-light camera",
          ModuleQuery.of(CameraSensor.class)
              .where(CameraAttributes.class, "band", Condition.equalTo(Band.VISIBLE)));

  final Question<CameraSensor> thermal =
      ask(
          "a thermal camera",
          ModuleQuery.of(CameraSensor.class)
              .where(CameraAttributes.class, "band", Condition.equalTo(Band.THERMAL)));

  final Question<BatterySensor> battery =
      ask("the battery's voltage", ModuleQuery.of(BatterySensor.class));

  RobotDevices(ModuleDirectory directory) {
    this.directory = directory;
  }

  private <M extends Module> Question<M> ask(String need, ModuleQuery<M> query) {
    Question<M> question = new Question<>(need, query);
    questions.add(question);
    return question;
  }

  /** All queries. */
  List<Question<?>> questions() {
    return questions;
  }

  /** Whether every query matches a working device. */
  boolean areAllAnswered() throws Exception {
    for (Question<?> each : questions) {
      if (listings(each).stream().noneMatch(RobotDevices::works)) {
        return false;
      }
    }
    return true;
  }

  private static boolean works(ModuleListing<?> listing) {
    return listing
        .attributes(org.dfra.persona.ModuleAttributes.class)
        .filter(module -> module.state().serves())
        .isPresent();
  }

  private <M extends Module> List<ModuleListing<M>> listings(Question<M> question)
      throws Exception {
    return directory.find(question.query());
  }

  /** The first module that matches a query. */
  <M extends Module> ModuleListing<M> one(Question<M> question) throws Exception {
    return listings(question).stream()
        .filter(RobotDevices::works)
        .findFirst()
        .orElseThrow(() -> new java.io.IOException("no module offers " + question.need()));
  }
}
