package org.dfra.sim.world.shape;

import java.util.Arrays;
import org.dfra.sim.world.shape.PlanarShape.Disc;

/**
 * Casts the beams of a range finder against obstacles and robots.
 *
 * <p>It iterates over near objects, not over beams: it transforms the corners of an outline into
 * the plane of the beams; their bearings select the beams that may hit an edge, and each of these
 * is intersected with it. So the cost depends on the visible objects, not on the free distance. It
 * supports tilted fans; beams that point down hit the ground. A beam that crosses an outline above
 * the object does not hit it, even where it would hit its top farther on.
 *
 * <p>Mutable, created once and used for every scan; confined to one thread.
 */
public final class RayCaster {

  /** Part of a laser's light that the ground returns. */
  public static final double GROUND_REFLECTIVITY = 0.2;

  private static final double TURN = 2 * Math.PI;
  private static final double EDGE = 1e-12; // extends edges, so that no beam passes between two
  private static final double LEVEL = 1e-12;

  private double first;
  private double step;
  private int beams;
  private double longest;
  private double[] cos = {};
  private double[] sin = {};
  private double[] distances = {};
  private double[] reflectivities = {};
  private final MutableTransform pose = new MutableTransform();
  private double inverse00;
  private double inverse01;
  private double inverse10;
  private double inverse11;
  private double stretch;
  private double bottom;
  private double top;
  private double reflectivity;

  /**
   * Sets the beams.
   *
   * @param firstAngle angle of the first beam in its own frame, radians, to the left is +
   * @param angleStep from one to the next, radians, not 0
   * @param beams how many
   */
  public void setBeams(double firstAngle, double angleStep, int beams) {
    if (firstAngle == this.first && angleStep == this.step && beams == this.beams) {
      return;
    }
    if (!(Math.abs(angleStep) > 0) || !Double.isFinite(firstAngle + angleStep)) {
      throw new IllegalArgumentException(
          "beams from "
              + firstAngle
              + " by "
              + angleStep
              + " rad are invalid; give finite angles and a step other than 0");
    }
    this.first = firstAngle;
    this.step = angleStep;
    this.beams = beams;
    cos = new double[beams];
    sin = new double[beams];
    distances = new double[beams];
    reflectivities = new double[beams];
    for (int i = 0; i < beams; i++) {
      cos[i] = StrictMath.cos(firstAngle + i * angleStep);
      sin[i] = StrictMath.sin(firstAngle + i * angleStep);
    }
  }

  /**
   * Starts a scan.
   *
   * @param from pose of the range finder; within 60° of level, upside down or not
   * @param maxRange maximum range, metres
   */
  public void beginScan(MutableTransform from, double maxRange) {
    pose.set(from);
    this.longest = maxRange;
    double determinant = pose.xx * pose.yy - pose.xy * pose.yx;
    if (!(Math.abs(determinant) > 0.4)) {
      throw new IllegalArgumentException(
          "beams tilted by more than 60° from the level cannot be simulated; tilt them less");
    }
    inverse00 = pose.yy / determinant;
    inverse01 = -pose.xy / determinant;
    inverse10 = -pose.yx / determinant;
    inverse11 = pose.xx / determinant;
    stretch = 1 / Math.abs(determinant);
    Arrays.fill(distances, maxRange);
    Arrays.fill(reflectivities, 0);
    if (Math.abs(pose.zx) > LEVEL || Math.abs(pose.zy) > LEVEL) {
      intersectGround();
    }
  }

  /** Range of a beam, metres; positive infinity without a hit. */
  public double distance(int beam) {
    return reflectivities[beam] > 0 ? distances[beam] : Double.POSITIVE_INFINITY;
  }

  /** Reflectivity of a beam's target; 0 without a hit. */
  public double reflectivity(int beam) {
    return reflectivities[beam];
  }

  private void intersectGround() {
    for (int i = 0; i < beams; i++) {
      double down = -(pose.zx * cos[i] + pose.zy * sin[i]);
      if (down > 0 && pose.up / down < distances[i]) {
        distances[i] = pose.up / down;
        reflectivities[i] = GROUND_REFLECTIVITY;
      }
    }
  }

  /** Casts the beams against an obstacle, from outside of it. */
  public void intersect(StaticObstacle solid) {
    Disc bounds = solid.bounds;
    if (isFar(bounds.east(), bounds.north(), bounds.radius())) {
      return;
    }
    bottom = 0;
    top = solid.height();
    reflectivity = Math.max(solid.reflectivity(), Double.MIN_NORMAL);
    if (solid.isDisc()) {
      intersectDisc(bounds);
      return;
    }
    int last = solid.east.length - 1;
    double fromEast = solid.east[last];
    double fromNorth = solid.north[last];
    for (int i = 0; i <= last; i++) {
      intersectEdge(fromEast, fromNorth, solid.east[i], solid.north[i]);
      fromEast = solid.east[i];
      fromNorth = solid.north[i];
    }
  }

  /**
   * Casts the beams against a box, from outside of it.
   *
   * @param bottom metres above the ground
   * @param top metres above the ground
   * @param reflectivity part of the light that it returns, above 0
   */
  public void intersect(OrientedRectangle box, double bottom, double top, double reflectivity) {
    if (isFar(box.east, box.north, box.radius)) {
      return;
    }
    this.bottom = bottom;
    this.top = top;
    this.reflectivity = reflectivity;
    double fromEast = box.cornerEast(3);
    double fromNorth = box.cornerNorth(3);
    for (int i = 0; i < 4; i++) {
      double toEast = box.cornerEast(i);
      double toNorth = box.cornerNorth(i);
      intersectEdge(fromEast, fromNorth, toEast, toNorth);
      fromEast = toEast;
      fromNorth = toNorth;
    }
  }

  private boolean isFar(double east, double north, double radius) {
    double x = east - pose.east;
    double y = north - pose.north;
    double reach = longest + radius;
    return x * x + y * y > reach * reach;
  }

  /** An edge with the inside to its left; it is not visible from there. */
  private void intersectEdge(double ax, double ay, double bx, double by) {
    if (LineSegments.side(ax, ay, bx, by, pose.east, pose.north) >= 0) {
      return;
    }
    double east = ax - pose.east;
    double north = ay - pose.north;
    double px = inverse00 * east + inverse01 * north;
    double py = inverse10 * east + inverse11 * north;
    double ex = inverse00 * (bx - ax) + inverse01 * (by - ay);
    double ey = inverse10 * (bx - ax) + inverse11 * (by - ay);
    double from = ApproximateAngles.atan2(px, py);
    double turn = ApproximateAngles.wrapped(ApproximateAngles.atan2(px + ex, py + ey) - from);
    cut(Math.min(from, from + turn), Math.abs(turn), px, py, ex, ey);
  }

  /** Intersects an edge with the beams whose bearings lie between those of its ends. */
  private void cut(double from, double turn, double px, double py, double ex, double ey) {
    double margin = ApproximateAngles.ERROR / Math.abs(step) + 1e-6;
    double low = (step > 0 ? from - first : from + turn - first) / step - margin;
    double high = low + turn / Math.abs(step) + 2 * margin;
    double period = TURN / Math.abs(step);
    double round = Math.ceil(-high / period) * period;
    double numerator = px * ey - py * ex;
    for (; low + round <= beams - 1; round += period) {
      int end = (int) Math.min(beams - 1, Math.floor(high + round));
      for (int i = (int) Math.max(0, Math.ceil(low + round)); i <= end; i++) {
        double c = cos[i];
        double s = sin[i];
        double across = c * ey - s * ex;
        double distance = numerator / across;
        double along = (px * s - py * c) / across;
        if (distance > 0 && along >= -EDGE && along <= 1 + EDGE) {
          recordHit(i, distance);
        }
      }
    }
  }

  private void intersectDisc(Disc disc) {
    double x = pose.east - disc.east();
    double y = pose.north - disc.north();
    double outside = x * x + y * y - disc.radius() * disc.radius();
    if (outside <= 0) {
      return;
    }
    double qx = -(inverse00 * x + inverse01 * y);
    double qy = -(inverse10 * x + inverse11 * y);
    double sine = disc.radius() * stretch / Math.sqrt(qx * qx + qy * qy);
    double half =
        sine >= 0.99 ? Math.PI : ApproximateAngles.atan2(Math.sqrt(1 - sine * sine), sine);
    double low =
        (ApproximateAngles.atan2(qx, qy) - first) / step
            - (half + 2 * ApproximateAngles.ERROR) / Math.abs(step);
    double high = low + 2 * (half + 2 * ApproximateAngles.ERROR) / Math.abs(step);
    double period = TURN / Math.abs(step);
    double round = Math.ceil(-high / period) * period;
    for (; low + round <= beams - 1; round += period) {
      int end = (int) Math.min(beams - 1, Math.floor(high + round));
      for (int i = (int) Math.max(0, Math.ceil(low + round)); i <= end; i++) {
        double dx = pose.xx * cos[i] + pose.xy * sin[i];
        double dy = pose.yx * cos[i] + pose.yy * sin[i];
        double a = dx * dx + dy * dy;
        double b = dx * x + dy * y;
        double root = b * b - a * outside;
        if (b < 0 && root >= 0) {
          recordHit(i, (-b - Math.sqrt(root)) / a);
        }
      }
    }
  }

  private void recordHit(int beam, double distance) {
    if (distance < distances[beam]) {
      double up = pose.up + distance * (pose.zx * cos[beam] + pose.zy * sin[beam]);
      if (up >= bottom && up <= top) {
        distances[beam] = distance;
        reflectivities[beam] = reflectivity;
      }
    }
  }

  /** Fast approximate angles that select the beams to test; results do not depend on them. */
  private static final class ApproximateAngles {

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
          t
              * (0.9998660
                  + tt * (-0.3302995 + tt * (0.1801410 + tt * (-0.0851330 + tt * 0.0208351))));
      double quadrant = ay > ax ? Math.PI / 2 - a : a;
      double half = x < 0 ? Math.PI - quadrant : quadrant;
      return y < 0 ? -half : half;
    }

    /** The same angle, wrapped to −π to π. */
    static double wrapped(double angle) {
      return angle > Math.PI ? angle - 2 * Math.PI : angle < -Math.PI ? angle + 2 * Math.PI : angle;
    }
  }
}
