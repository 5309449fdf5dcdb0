package org.dfra.behaviors.raster;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.dfra.behaviors.raster.LaneSegmentSequence.LaneSegment;
import org.locationtech.jts.geom.Coordinate;
import org.locationtech.jts.geom.Geometry;
import org.locationtech.jts.geom.GeometryFactory;
import org.locationtech.jts.geom.Polygon;

/**
 * Finds the gaps in the lanes' coverage, and adds short lanes along the outline that cover them.
 *
 * <pre>
 *      line     edge   outer border of the strip
 *        |     /      |          A point of the polygon either sees its strip's line straight
 *        |    /.......|          across the lanes, at most half a strip's width away, with a lane
 *        |   /.behind.|          there; or an edge of the outline is in between, nearer than that.
 *        |  /.........|          So an area that no lane covers lies behind an edge, and a drive
 *        | /..........|          along the edge covers it.
 * </pre>
 *
 * <p>Behind each such edge, the area that nearby lanes do not cover is computed exactly; if it is
 * not empty, the shortest part of the edge that covers it is added.
 */
final class CoverageGapFiller {

  /** Gaps up to this width count as covered, metres. */
  static final double GRAIN = 5e-7;

  private static final double LEAST_AREA = 1e-9; // square metres: numerical residue of overlays
  private static final int QUADRANT = 16; // corners of a quarter circle, which lie on it
  private static final int HALVINGS = 20;

  private final Polygon polygon;
  private final StripDecomposition lines;
  private final double range;
  private final List<List<LaneSegment>> strokes =
      new ArrayList<>(); // by strip: lanes, then added ones
  private final List<LaneSegment> found = new ArrayList<>();

  /**
   * @param range of view to either side, metres
   */
  CoverageGapFiller(Polygon polygon, StripDecomposition lines, double range) {
    this.polygon = polygon;
    this.lines = lines;
    this.range = range + GRAIN;
    for (int strip = 0; strip < lines.count(); strip++) {
      strokes.add(new ArrayList<>(lines.lanes(strip)));
    }
  }

  /** The added short lanes, from west to east. */
  List<LaneSegment> fill() {
    Coordinate[] ring = polygon.getExteriorRing().getCoordinates(); // counter-clockwise
    for (int strip = 0; strip < lines.count(); strip++) {
      for (int i = 1; i < ring.length; i++) {
        boolean isInsideWest = ring[i].y > ring[i - 1].y;
        double middle = lines.centreLine(strip);
        double outer = lines.border(isInsideWest ? strip : strip + 1);
        behind(ring[i - 1], ring[i], middle, outer, strip);
      }
    }
    return found;
  }

  private void behind(Coordinate a, Coordinate b, double middle, double outer, int strip) {
    double west = Math.min(middle, outer);
    double east = Math.max(middle, outer);
    if (Math.max(a.x, b.x) <= west || Math.min(a.x, b.x) >= east) {
      return;
    }
    Coordinate from = clipped(a, b, west, east);
    Coordinate to = clipped(b, a, west, east);
    boolean isThin =
        Math.abs(from.y - to.y) < GRAIN
            || Math.max(Math.abs(from.x - outer), Math.abs(to.x - outer)) < GRAIN;
    if (isThin) {
      return;
    }
    Coordinate[] corners = {
      from, to, new Coordinate(outer, to.y), new Coordinate(outer, from.y), from
    };
    List<LaneSegment> near = near(corners, strip);
    if (near.stream().anyMatch(stroke -> sees(stroke, corners))) {
      return; // and skips the overlay, which few regions need
    }
    Geometry unseen = unseen(corners, near);
    for (int i = 0; i < unseen.getNumGeometries(); i++) {
      Geometry part = unseen.getGeometryN(i);
      if (!isSeen(part, near(corners, strip))) {
        LaneSegment stroke = shortest(from, to, part.getCoordinates(), strip);
        found.add(stroke);
        strokes.get(strip).add(stroke);
      }
    }
  }

  /** The end a of an edge, or the point where the edge to b enters the strip. */
  private static Coordinate clipped(Coordinate a, Coordinate b, double west, double east) {
    double x = Math.max(west, Math.min(east, a.x));
    return x == a.x ? a : new Coordinate(x, a.y + (x - a.x) / (b.x - a.x) * (b.y - a.y));
  }

  /** Whether a segment covers the convex hull of points: the distance to it is convex. */
  private boolean sees(LaneSegment stroke, Coordinate[] points) {
    return Arrays.stream(points).allMatch(point -> stroke.distance(point) <= range);
  }

  /**
   * Whether one segment covers a part completely; or several do, where it is only numerical
   * residue. The tip of an acute corner has a negligible area, too, and still is far from the
   * covered area.
   */
  private boolean isSeen(Geometry part, List<LaneSegment> near) {
    Coordinate[] points = part.getCoordinates();
    return near.stream().anyMatch(stroke -> sees(stroke, points))
        || (part.getArea() <= LEAST_AREA
            && Arrays.stream(points)
                .allMatch(p -> near.stream().anyMatch(stroke -> stroke.distance(p) <= range)));
  }

  private List<LaneSegment> near(Coordinate[] corners, int strip) {
    int reach = (int) Math.ceil(range / lines.width() + 0.5);
    double south = Math.min(corners[0].y, corners[1].y) - range;
    double north = Math.max(corners[0].y, corners[1].y) + range;
    List<LaneSegment> near = new ArrayList<>();
    for (int i = Math.max(0, strip - reach); i <= Math.min(strip + reach, lines.count() - 1); i++) {
      for (LaneSegment stroke : strokes.get(i)) {
        if (Math.max(stroke.from().y, stroke.to().y) >= south
            && Math.min(stroke.from().y, stroke.to().y) <= north) {
          near.add(stroke);
        }
      }
    }
    return near;
  }

  private Geometry unseen(Coordinate[] corners, List<LaneSegment> near) {
    GeometryFactory factory = polygon.getFactory();
    Geometry unseen = SnappedOverlay.intersection(factory.createPolygon(corners), polygon);
    for (LaneSegment stroke : near) {
      if (unseen.isEmpty()) {
        return unseen;
      }
      Geometry seen =
          factory
              .createLineString(new Coordinate[] {stroke.from(), stroke.to()})
              .buffer(range, QUADRANT);
      unseen = SnappedOverlay.difference(unseen, seen);
    }
    return unseen;
  }

  /**
   * The shortest part of an edge that covers all points; the parts opposite the points do in any
   * case.
   */
  private LaneSegment shortest(Coordinate from, Coordinate to, Coordinate[] points, int strip) {
    double least = 1;
    double most = 0;
    for (Coordinate point : points) {
      double share = Math.max(0, Math.min(1, (point.y - from.y) / (to.y - from.y)));
      least = Math.min(least, share);
      most = Math.max(most, share);
    }
    double keep = Math.min(most - least, lines.width() / 4 / from.distance(to));
    double low = least;
    double high = most - keep;
    for (int i = 0; i < HALVINGS; i++) {
      double middle = (low + high) / 2;
      boolean isEnough = sees(part(from, to, middle, most, strip), points);
      low = isEnough ? middle : low;
      high = isEnough ? high : middle;
    }
    double begin = low;
    low = begin + keep;
    high = most;
    for (int i = 0; i < HALVINGS; i++) {
      double middle = (low + high) / 2;
      boolean isEnough = sees(part(from, to, begin, middle, strip), points);
      high = isEnough ? middle : high;
      low = isEnough ? low : middle;
    }
    return part(from, to, begin, high, strip);
  }

  private static LaneSegment part(
      Coordinate from, Coordinate to, double begin, double end, int strip) {
    return new LaneSegment(between(from, to, begin), between(from, to, end), strip);
  }

  private static Coordinate between(Coordinate from, Coordinate to, double share) {
    return new Coordinate(from.x + share * (to.x - from.x), from.y + share * (to.y - from.y));
  }
}
