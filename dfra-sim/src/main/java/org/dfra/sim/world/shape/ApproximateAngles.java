package org.dfra.sim.world.shape;

/** Fast approximate angles that select the beams to test; results do not depend on them. */
final class ApproximateAngles {

  /** Maximum error of {@link #atan2}, radians. */
  static final double ERROR = 2e-5;

  private ApproximateAngles() {}

  /**
   * Approximates {@code atan2(y, x)} by a polynomial. Source: Abramowitz and Stegun, "Handbook of
   * Mathematical Functions", 4.4.49, accurate to 1e-5 rad.
   */
  static double atan2(double x, double y) {
    double ax = Math.abs(x);
    double ay = Math.abs(y);
    double t = ax >= ay ? ay / Math.max(ax, Double.MIN_NORMAL) : ax / ay;
    double tt = t * t;
    double a =
        t * (0.9998660 + tt * (-0.3302995 + tt * (0.1801410 + tt * (-0.0851330 + tt * 0.0208351))));
    double quadrant = ay > ax ? Math.PI / 2 - a : a;
    double half = x < 0 ? Math.PI - quadrant : quadrant;
    return y < 0 ? -half : half;
  }

  /** The same angle, wrapped to −π to π. */
  static double wrapped(double angle) {
    return angle > Math.PI ? angle - 2 * Math.PI : angle < -Math.PI ? angle + 2 * Math.PI : angle;
  }
}
