package org.dfra.behaviors.perceptual.mines;

/**
 * A point on the ground.
 *
 * @param x forward of a robot's base, or east; metres
 * @param y to the left of it, or north; metres
 */
public record GroundPoint(double x, double y) {

  /** Metres to another. */
  public double distance(GroundPoint other) {
    return Math.hypot(x - other.x, y - other.y);
  }
}
