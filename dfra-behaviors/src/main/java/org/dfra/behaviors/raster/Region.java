package org.dfra.behaviors.raster;

import java.util.ArrayList;
import java.util.List;
import org.dfra.behavior.GoalRefusedException;
import org.dfra.geometry.GeoPosition;
import org.dfra.geometry.LocalFrame;
import org.dfra.geometry.LocalPosition;
import org.locationtech.jts.geom.Coordinate;
import org.locationtech.jts.geom.GeometryFactory;
import org.locationtech.jts.geom.Polygon;

/**
 * An area that a robot can search: a simple polygon without holes. Its edges are straight in the
 * tangent plane of the ellipsoid at its centre. Immutable.
 */
public final class Region {

  /** Maximum distance of two corners, metres. */
  public static final double WIDEST = 10_000;

  /** Maximum number of corners. */
  public static final int MOST_CORNERS = 500;

  /** Square metres. */
  private static final double LEAST_AREA = 0.01;

  private static final GeometryFactory FACTORY = new GeometryFactory();

  private final List<GeoPosition> corners;
  private final LocalFrame frame;
  private final Polygon polygon;

  private Region(List<GeoPosition> corners, LocalFrame frame, Polygon polygon) {
    this.corners = corners;
    this.frame = frame;
    this.polygon = polygon;
  }

  /**
   * Creates the region within corners.
   *
   * @param given the corners in order, in either direction; heights are ignored, and a corner that
   *     repeats its predecessor, or the first one at the end, is dropped
   * @throws GoalRefusedException if they are fewer than three, enclose no area, lie too far apart,
   *     or if their outline crosses itself; the message gives the place
   */
  public static Region of(List<GeoPosition> given) {
    List<GeoPosition> corners = different(given);
    if (corners.size() < 3 || corners.size() > MOST_CORNERS) {
      throw new GoalRefusedException(
          "a region of "
              + corners.size()
              + (corners.size() < 3
                  ? " different corners encloses nothing; give three or more"
                  : " corners has too many; simplify its outline to "
                      + MOST_CORNERS
                      + " or fewer"));
    }
    LocalFrame first = new LocalFrame(corners.get(0));
    Polygon seenFromFirst = polygon(corners, first);
    RegionValidation.requireWithinExtent(corners, seenFromFirst);
    RegionValidation.requireSimple(corners, seenFromFirst);
    if (seenFromFirst.getArea() < LEAST_AREA) {
      throw new GoalRefusedException(
          "the region at "
              + corners.get(0).latitudeAndLongitude()
              + " encloses almost no area; give corners that do not lie on one line");
    }
    Coordinate middle = seenFromFirst.getCentroid().getCoordinate();
    LocalFrame frame = new LocalFrame(onGround(first, middle.x, middle.y));
    return new Region(List.copyOf(corners), frame, polygon(corners, frame));
  }

  /** Its corners in the order given, height 0, the first not repeated. */
  public List<GeoPosition> corners() {
    return corners;
  }

  /** The centroid of its area, on the ellipsoid; in a non-convex region it may lie outside. */
  public GeoPosition centre() {
    return frame.datum();
  }

  /** The planning frame: ENU, its datum is the centre. */
  public LocalFrame frame() {
    return frame;
  }

  /** Square metres. */
  public double area() {
    return polygon.getArea();
  }

  /** Its outline in its frame: x is east, y is north, metres. */
  Polygon polygon() {
    return polygon;
  }

  /** The point of the ellipsoid at the given metres east and north of the centre. */
  GeoPosition onGround(double east, double north) {
    return onGround(frame, east, north);
  }

  /**
   * The plane lies above the ellipsoid all around its datum. A foot of the vertical on the
   * ellipsoid would be off by 1.5 mm in 5 km; the result is the point that the frame transforms to
   * this east and north.
   */
  private static GeoPosition onGround(LocalFrame frame, double east, double north) {
    double up = 0;
    GeoPosition there = frame.toGeo(new LocalPosition(east, north, up));
    for (int i = 0; i < 2; i++) { // each iteration reduces the error to a millionth
      up -= there.height();
      there = frame.toGeo(new LocalPosition(east, north, up));
    }
    return new GeoPosition(there.latitude(), there.longitude(), 0);
  }

  private static List<GeoPosition> different(List<GeoPosition> given) {
    List<GeoPosition> corners = new ArrayList<>();
    for (GeoPosition each : given) {
      GeoPosition corner = new GeoPosition(each.latitude(), each.longitude(), 0);
      if (corners.isEmpty() || !corner.equals(corners.get(corners.size() - 1))) {
        corners.add(corner);
      }
    }
    while (corners.size() > 1 && corners.get(0).equals(corners.get(corners.size() - 1))) {
      corners.remove(corners.size() - 1);
    }
    return corners.stream().distinct().count() < 3 ? corners.stream().distinct().toList() : corners;
  }

  private static Polygon polygon(List<GeoPosition> corners, LocalFrame frame) {
    Coordinate[] ring = new Coordinate[corners.size() + 1];
    for (int i = 0; i < corners.size(); i++) {
      LocalPosition at = frame.toLocal(corners.get(i));
      ring[i] = new Coordinate(at.east(), at.north());
    }
    ring[corners.size()] = ring[0].copy();
    return FACTORY.createPolygon(ring);
  }
}
