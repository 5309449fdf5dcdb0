package org.dfra.behaviors.raster;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import org.dfra.behavior.GoalRefusedException;
import org.dfra.behaviors.raster.LaneSegmentSequence.LaneSegment;
import org.dfra.geometry.GeoPosition;
import org.locationtech.jts.geom.Coordinate;
import org.locationtech.jts.geom.Envelope;
import org.locationtech.jts.geom.Polygon;

/**
 * A polygon divided into strips of equal width, with a line along the middle of each, and the parts
 * of the line inside: the lanes. The strips are as wide as the spacing or a little less (a
 * thousandth more at most, and never more than the swath), so that a whole number of them is as
 * wide as the polygon.
 */
final class StripDecomposition {

  private static final int MOST = 10_000;

  /** Excess width that does not require another lane, if the swath covers it. */
  private static final double SPARED = 1e-3;

  /** Minimum distance of a line from corners, metres, so that its intersections are unambiguous. */
  private static final double OFF_CORNERS = 1e-7;

  private final double west;
  private final double width;
  private final double[] middles;
  private final List<List<LaneSegment>> lanes = new ArrayList<>();

  /**
   * @param polygon in the planner's axes
   * @param spacing metres, above 0
   * @param swath metres, at least the spacing
   * @param where place for the error message
   * @throws GoalRefusedException if there would be too many lines
   */
  StripDecomposition(Polygon polygon, double spacing, double swath, GeoPosition where) {
    Envelope bounds = polygon.getEnvelopeInternal();
    double count = Math.max(1, Math.ceil(bounds.getWidth() / spacing - SPARED));
    if (bounds.getWidth() / count > swath) {
      count = Math.ceil(bounds.getWidth() / swath);
    }
    if (!(count <= MOST)) {
      throw new GoalRefusedException(
          String.format(
              Locale.ROOT,
              "the region at %s is %.1f m wide, which makes %.0f lanes %s m apart, more than %d;"
                  + " give a greater spacing, or search it in parts",
              where.latitudeAndLongitude(),
              bounds.getWidth(),
              count,
              spacing,
              MOST));
    }
    this.west = bounds.getMinX();
    this.width = bounds.getWidth() / count;
    this.middles = new double[(int) count];
    Coordinate[] ring = polygon.getExteriorRing().getCoordinates();
    double[] corners = Arrays.stream(ring).mapToDouble(Coordinate::getX).sorted().toArray();
    for (int i = 0; i < middles.length; i++) {
      middles[i] = offCorners(west + (i + 0.5) * width, corners);
      lanes.add(inside(ring, i));
    }
  }

  private static double offCorners(double x, double[] corners) {
    double line = x;
    for (double corner : corners) {
      if (Math.abs(corner - line) < OFF_CORNERS) {
        line = corner + OFF_CORNERS;
      }
    }
    return line;
  }

  private List<LaneSegment> inside(Coordinate[] ring, int strip) {
    double x = middles[strip];
    List<Double> crossings = new ArrayList<>();
    for (int i = 1; i < ring.length; i++) {
      Coordinate a = ring[i - 1];
      Coordinate b = ring[i];
      if (a.x < x != b.x < x) {
        double share = (x - a.x) / (b.x - a.x);
        crossings.add(a.y + share * (b.y - a.y));
      }
    }
    crossings.sort(null);
    List<LaneSegment> inside = new ArrayList<>();
    for (int i = 1; i < crossings.size(); i += 2) {
      Coordinate from = new Coordinate(x, crossings.get(i - 1));
      inside.add(new LaneSegment(from, new Coordinate(x, crossings.get(i)), strip));
    }
    return inside;
  }

  /** Number of strips. */
  int count() {
    return middles.length;
  }

  /** Width of a strip, metres. */
  double width() {
    return width;
  }

  /** Position of the line of a strip. */
  double centreLine(int strip) {
    return middles[strip];
  }

  /**
   * The border between a strip and its predecessor; at index {@link #count} it is the eastern end.
   */
  double border(int strip) {
    return west + strip * width;
  }

  /** The lanes in a strip from south to north, each of them northward. */
  List<LaneSegment> lanes(int strip) {
    return lanes.get(strip);
  }
}
