package org.dfra.core.policy;

import java.util.List;
import org.dfra.geometry.GeoPosition;
import org.jspecify.annotations.Nullable;

/**
 * A named area on the ground: a polygon whose edges are straight in degrees of latitude and
 * longitude. It does not cross the meridian at 180°.
 *
 * @param corners 3 to {@value #MAX_CORNERS}, in order, in either direction; heights are ignored
 */
record PolicyRegion(String name, List<GeoPosition> corners) {

  static final int MAX_CORNERS = 200;

  /** Degrees; a wider region is a mistake, or crosses the meridian at 180°. */
  private static final double MAX_WIDTH = 10;

  PolicyRegion {
    corners = List.copyOf(corners);
  }

  /** What is wrong with such corners, and the remedy; null if they enclose an area. */
  static @Nullable String fault(List<GeoPosition> corners) {
    int count = corners.size();
    if (count < 3 || count > MAX_CORNERS) {
      return "a region of "
          + count
          + " corners is outside 3 to "
          + MAX_CORNERS
          + "; give each corner as <corner latitude=\"…\" longitude=\"…\"/>";
    }
    double west = corners.stream().mapToDouble(GeoPosition::longitude).min().orElse(0);
    double east = corners.stream().mapToDouble(GeoPosition::longitude).max().orElse(0);
    if (east - west > MAX_WIDTH) {
      return "the region is "
          + (east - west)
          + "° wide, at most "
          + MAX_WIDTH
          + "° are allowed; correct a longitude";
    }
    for (int i = 0; i < count; i++) {
      for (int j = i + 2; j < count; j++) {
        boolean areNeighbours = i == 0 && j == count - 1;
        if (!areNeighbours && cross(edge(corners, i), edge(corners, j))) {
          return "the edges after corners "
              + (i + 1)
              + " and "
              + (j + 1)
              + " cross; give the corners in their order around the region";
        }
      }
    }
    return area(corners) == 0
        ? "the region encloses no area; give corners that do not lie on one line"
        : null;
  }

  private record Edge(GeoPosition from, GeoPosition to) {

    /** On which side of this edge a point lies: above 0 left, below 0 right. */
    double side(GeoPosition point) {
      return (to.longitude() - from.longitude()) * (point.latitude() - from.latitude())
          - (to.latitude() - from.latitude()) * (point.longitude() - from.longitude());
    }
  }

  private static Edge edge(List<GeoPosition> corners, int index) {
    return new Edge(corners.get(index), corners.get((index + 1) % corners.size()));
  }

  private static boolean cross(Edge one, Edge other) {
    return one.side(other.from()) * one.side(other.to()) < 0
        && other.side(one.from()) * other.side(one.to()) < 0;
  }

  /** Twice the area in square degrees, by the shoelace formula. */
  private static double area(List<GeoPosition> corners) {
    GeoPosition origin = corners.get(0);
    double sum = 0;
    for (int i = 1; i + 1 < corners.size(); i++) {
      sum += new Edge(origin, corners.get(i)).side(corners.get(i + 1));
    }
    return sum;
  }

  /** Whether a position is inside; on the outline, either. */
  boolean contains(GeoPosition position) {
    boolean inside = false;
    for (int i = 0; i < corners.size(); i++) {
      GeoPosition from = corners.get(i);
      GeoPosition to = corners.get((i + 1) % corners.size());
      boolean isBetween =
          (from.latitude() > position.latitude()) != (to.latitude() > position.latitude());
      if (isBetween) {
        double share = (position.latitude() - from.latitude()) / (to.latitude() - from.latitude());
        double longitude = from.longitude() + share * (to.longitude() - from.longitude());
        inside ^= position.longitude() < longitude;
      }
    }
    return inside;
  }
}
