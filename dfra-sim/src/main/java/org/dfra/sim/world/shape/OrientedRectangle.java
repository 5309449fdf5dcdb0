package org.dfra.sim.world.shape;

import org.dfra.sim.world.shape.PlanarShape.Disc;

/**
 * The footprint of a body at its current pose. Mutable, created once and moved; confined to one
 * thread.
 */
public final class OrientedRectangle {

  final double halfLength;
  final double halfWidth;
  final double radius;
  double east;
  double north;
  double cos = 1;
  double sin;

  /**
   * @param length along the body's x axis, metres, above 0
   * @param width along its y axis, metres, above 0
   */
  public OrientedRectangle(double length, double width) {
    this.halfLength = length / 2;
    this.halfWidth = width / 2;
    this.radius = Math.sqrt(halfLength * halfLength + halfWidth * halfWidth);
  }

  /**
   * Moves it.
   *
   * @param east of its centre, metres
   * @param north of its centre, metres
   * @param cos of its yaw
   * @param sin of its yaw
   */
  public void move(double east, double north, double cos, double sin) {
    this.east = east;
    this.north = north;
    this.cos = cos;
    this.sin = sin;
  }

  /** Radius of its bounding disc, metres. */
  public double radius() {
    return radius;
  }

  /** East of its corner, counter-clockwise from the left front one, metres. */
  double cornerEast(int corner) {
    return east + cos * along(corner) - sin * across(corner);
  }

  /** North of its corner, metres. */
  double cornerNorth(int corner) {
    return north + sin * along(corner) + cos * across(corner);
  }

  private double along(int corner) {
    return corner == 0 || corner == 3 ? halfLength : -halfLength;
  }

  private double across(int corner) {
    return corner < 2 ? halfWidth : -halfWidth;
  }

  /** Whether it touches an obstacle's outline. */
  public boolean touches(StaticObstacle solid) {
    Disc bounds = solid.bounds;
    double x = bounds.east() - east;
    double y = bounds.north() - north;
    double reach = radius + bounds.radius();
    if (x * x + y * y > reach * reach) {
      return false;
    }
    return solid.isDisc() ? touches(x, y, bounds.radius()) : touchesPolygon(solid);
  }

  /** Whether it touches another rectangle. */
  public boolean touches(OrientedRectangle other) {
    double x = other.east - east;
    double y = other.north - north;
    double reach = radius + other.radius;
    return x * x + y * y <= reach * reach
        && !isDisjoint(other, x, y)
        && !other.isDisjoint(this, -x, -y);
  }

  /**
   * Whether one of this rectangle's axes separates the two; x and y point to the other's centre.
   */
  private boolean isDisjoint(OrientedRectangle other, double x, double y) {
    double c = Math.abs(cos * other.cos + sin * other.sin);
    double s = Math.abs(cos * other.sin - sin * other.cos);
    return Math.abs(cos * x + sin * y) > halfLength + c * other.halfLength + s * other.halfWidth
        || Math.abs(cos * y - sin * x) > halfWidth + s * other.halfLength + c * other.halfWidth;
  }

  private boolean touches(double x, double y, double discRadius) {
    double along = Math.max(0, Math.abs(cos * x + sin * y) - halfLength);
    double across = Math.max(0, Math.abs(cos * y - sin * x) - halfWidth);
    return along * along + across * across <= discRadius * discRadius;
  }

  private boolean touchesPolygon(StaticObstacle solid) {
    int last = solid.east.length - 1;
    double fromX = along(solid, last);
    double fromY = across(solid, last);
    for (int i = 0; i <= last; i++) {
      double toX = along(solid, i);
      double toY = across(solid, i);
      if (holdsPartOf(fromX, fromY, toX, toY)) {
        return true;
      }
      fromX = toX;
      fromY = toY;
    }
    return solid.outline().contains(east, north);
  }

  private double along(StaticObstacle solid, int corner) {
    return cos * (solid.east[corner] - east) + sin * (solid.north[corner] - north);
  }

  private double across(StaticObstacle solid, int corner) {
    return cos * (solid.north[corner] - north) - sin * (solid.east[corner] - east);
  }

  /**
   * Whether a segment intersects it, all in its own frame: the segment is clipped at the four
   * sides.
   */
  private boolean holdsPartOf(double ax, double ay, double bx, double by) {
    double from = 0;
    double to = 1;
    for (int side = 0; side < 4; side++) {
      boolean isAlong = side < 2;
      double sign = side % 2 == 0 ? 1 : -1;
      double half = isAlong ? halfLength : halfWidth;
      double a = sign * (isAlong ? ax : ay) - half; // outside of this side where above 0
      double b = sign * (isAlong ? bx : by) - half;
      if (a > 0 && b > 0) {
        return false;
      } else if (a > 0) {
        from = Math.max(from, a / (a - b));
      } else if (b > 0) {
        to = Math.min(to, a / (a - b));
      }
    }
    return from <= to;
  }
}
