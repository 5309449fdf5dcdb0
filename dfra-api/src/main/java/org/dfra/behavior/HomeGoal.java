package org.dfra.behavior;

/**
 * To return to the robot's start position.
 *
 * @param tolerance accepted distance from it, metres, above 0
 */
public record HomeGoal(double tolerance) implements Goal {

  public HomeGoal {
    if (!(tolerance > 0 && Double.isFinite(tolerance))) {
      throw new IllegalArgumentException("tolerance " + tolerance + " m is not above 0");
    }
  }
}
