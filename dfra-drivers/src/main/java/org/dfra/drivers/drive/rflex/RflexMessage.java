package org.dfra.drivers.drive.rflex;

import java.util.List;

/**
 * A message from an rFLEX controller. Numbers are in the controller's own unit unless a unit is
 * named.
 */
sealed interface RflexMessage {

  /** One of the two axes of motion that the controller drives and counts. */
  enum Axis {
    /** Translation along the robot's x. */
    TRANSLATION,
    /** Rotation about the robot's z. */
    ROTATION
  }

  /**
   * State of an axis, port 2 opcode 33. The sign of position and velocity is the direction of
   * motion.
   *
   * @param timestamp the controller's clock, unsigned, in a unit that no source documents
   * @param axis which of the two
   * @param position counted since the controller was switched on; wraps around at 32 bits
   * @param velocity counts per second
   * @param acceleration counts per second squared
   * @param torque in the controller's unit
   */
  record MotorReport(
      long timestamp, Axis axis, int position, int velocity, int acceleration, int torque)
      implements RflexMessage {}

  /**
   * Status of the controller, port 1 opcode 1.
   *
   * @param timestamp as in {@link MotorReport}
   * @param voltage volts as measured, about 1.2 V below those at the battery
   * @param brakeSet whether the brake is set
   */
  record SystemStatus(long timestamp, double voltage, boolean brakeSet) implements RflexMessage {}

  /**
   * The echoes of the sonars, port 4 opcode 2.
   *
   * @param timestamp as in {@link MotorReport}
   * @param echoes in the order reported
   */
  record SonarReport(long timestamp, List<Echo> echoes) implements RflexMessage {

    public SonarReport {
      echoes = List.copyOf(echoes);
    }
  }

  /**
   * One sonar's echo.
   *
   * @param sonar its number
   * @param range metres
   */
  record Echo(int sonar, double range) {}

  /**
   * An intact frame that this driver does not use.
   *
   * @param port which part of the controller
   * @param opcode kind of the frame
   * @param length of its data in bytes
   */
  record Other(int port, int opcode, int length) implements RflexMessage {}

  /**
   * An intact frame with invalid values.
   *
   * @param port which part of the controller
   * @param opcode kind of the frame
   * @param reason which value, as a clause
   */
  record Malformed(int port, int opcode, String reason) implements RflexMessage {}
}
