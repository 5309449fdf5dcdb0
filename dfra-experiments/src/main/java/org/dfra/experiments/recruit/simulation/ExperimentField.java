package org.dfra.experiments.recruit.simulation;

import org.dfra.geometry.GeoPosition;
import org.dfra.geometry.LocalFrame;
import org.dfra.geometry.LocalPosition;

/** The field: a square. */
final class ExperimentField {

  /** Length of a side, metres. */
  static final double SIDE = 100;

  /** From corner to corner, metres. */
  static final double DIAGONAL = SIDE * Math.sqrt(2);

  private static final LocalFrame FRAME = new LocalFrame(new GeoPosition(28.06, -82.41, 0));

  private ExperimentField() {}

  static FieldPoint toField(GeoPosition place) {
    LocalPosition local = FRAME.toLocal(place);
    return new FieldPoint(local.east(), local.north());
  }

  static GeoPosition toEarth(FieldPoint point) {
    return FRAME.toGeo(new LocalPosition(point.east(), point.north(), 0));
  }

  static boolean contains(FieldPoint point) {
    return point.east() >= 0 && point.east() <= SIDE && point.north() >= 0 && point.north() <= SIDE;
  }

  /**
   * A point in the field.
   *
   * @param east of its south-west corner, metres
   * @param north of it, metres
   */
  record FieldPoint(double east, double north) {

    double distance(FieldPoint other) {
      return Math.hypot(east - other.east, north - other.north);
    }

    /** Interpolates towards another point, 0 to 1. */
    FieldPoint towards(FieldPoint other, double share) {
      return new FieldPoint(
          east + share * (other.east - east), north + share * (other.north - north));
    }
  }

  /**
   * Lanes over a rectangle, driven back and forth repeatedly. Lanes run north and south; frame
   * east, north, metres.
   */
  static final class RasterRoute {

    private final double west;
    private final double south;
    private final double height;
    private final double spacing;
    private final int lanes;

    /**
     * @param width of the rectangle, metres
     * @param height likewise
     * @param spacing between lanes, metres
     */
    RasterRoute(double west, double south, double width, double height, double spacing) {
      this.west = west;
      this.south = south;
      this.height = height;
      this.spacing = spacing;
      this.lanes = (int) (width / spacing) + 1;
    }

    /** Length from one end to the other, metres. */
    double length() {
      return lanes * height + (lanes - 1) * spacing;
    }

    /** The position after a driven distance, metres, not negative. */
    FieldPoint at(double way) {
      double there = way % (2 * length());
      double along = there <= length() ? there : 2 * length() - there;
      int lane = Math.min(lanes - 1, (int) (along / (height + spacing)));
      double inLane = along - lane * (height + spacing);
      double up = Math.min(inLane, height);
      double over = Math.max(0, inLane - height);
      return new FieldPoint(
          west + lane * spacing + over, south + (lane % 2 == 0 ? up : height - up));
    }
  }
}
