package org.dfra.behavior;

/**
 * To be back where the robot began.
 *
 * @param tolerance how near is near enough, metres, above 0
 */
public record HomeGoal(double tolerance) implements Goal {

  public HomeGoal {
    if (!(tolerance > 0 && Double.isFinite(tolerance))) {
      throw new IllegalArgumentException("tolerance " + tolerance + " m is not above 0");
    }
  }
}
