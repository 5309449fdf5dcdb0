package org.dfra.persona;

/**
 * How a drive moves its robot, and how large that is.
 *
 * @param maxSpeed metres per second
 * @param maxTurnRate radians per second
 * @param length of the robot, metres
 * @param width of the robot, metres
 */
public record DriveAttributes(double maxSpeed, double maxTurnRate, double length, double width)
    implements Attributes {

  public DriveAttributes {
    Checks.positive("speed", maxSpeed, "m/s");
    Checks.positive("turn rate", maxTurnRate, "rad/s");
    Checks.positive("length", length, "m");
    Checks.positive("width", width, "m");
  }
}
