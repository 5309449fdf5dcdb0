package org.dfra.persona;

/**
 * The limits of a drive, and the size of its robot.
 *
 * @param maxSpeed metres per second
 * @param maxYawRate radians per second
 * @param length of the robot, metres
 * @param width of the robot, metres
 */
public record DriveAttributes(double maxSpeed, double maxYawRate, double length, double width)
    implements Attributes {

  public DriveAttributes {
    AttributeValidation.requirePositive("speed", maxSpeed, "m/s");
    AttributeValidation.requirePositive("turn rate", maxYawRate, "rad/s");
    AttributeValidation.requirePositive("length", length, "m");
    AttributeValidation.requirePositive("width", width, "m");
  }
}
