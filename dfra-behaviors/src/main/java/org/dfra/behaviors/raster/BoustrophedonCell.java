package org.dfra.behaviors.raster;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.dfra.behaviors.raster.LaneSegmentSequence.LaneSegment;
import org.locationtech.jts.geom.Coordinate;
import org.locationtech.jts.geom.Envelope;
import org.locationtech.jts.geom.Geometry;
import org.locationtech.jts.geom.GeometryFactory;
import org.locationtech.jts.geom.Polygon;

/**
 * Lanes side by side, one in each of some strips in a row, that are driven back and forth without
 * transit paths. Cells begin and end where a notch of the outline begins or ends between two
 * strips. Source of the idea: H. Choset and P. Pignon, "Coverage path planning: the boustrophedon
 * cellular decomposition", FSR 1997.
 *
 * @param lanes from west to east, each of them northward; at least one
 */
record BoustrophedonCell(List<LaneSegment> lanes) {

  /** Number of traversals: from either end, starting at either end of a lane. */
  static final int TRAVERSALS = 4;

  /** The cells of a polygon, ordered by their western ends. */
  static List<BoustrophedonCell> of(Polygon polygon, StripDecomposition lines) {
    List<BoustrophedonCell> cells = new ArrayList<>();
    List<BoustrophedonCell> open = new ArrayList<>(); // one for each lane of the strip
    for (LaneSegment lane : lines.lanes(0)) {
      open.add(started(lane, cells));
    }
    for (int strip = 1; strip < lines.count(); strip++) {
      List<BoustrophedonCell> before = open;
      open = new ArrayList<>();
      int[] partners = partners(polygon, lines, strip);
      for (int i = 0; i < partners.length; i++) {
        LaneSegment lane = lines.lanes(strip).get(i);
        if (partners[i] < 0) {
          open.add(started(lane, cells));
        } else {
          before.get(partners[i]).lanes.add(lane);
          open.add(before.get(partners[i]));
        }
      }
    }
    return cells;
  }

  private static BoustrophedonCell started(LaneSegment lane, List<BoustrophedonCell> cells) {
    BoustrophedonCell cell = new BoustrophedonCell(new ArrayList<>(List.of(lane)));
    cells.add(cell);
    return cell;
  }

  /**
   * For each lane of a strip, its only predecessor, if that has no other successor; -1 where there
   * is none.
   */
  private static int[] partners(Polygon polygon, StripDecomposition lines, int strip) {
    List<LaneSegment> west = lines.lanes(strip - 1);
    List<LaneSegment> east = lines.lanes(strip);
    int[] partners = new int[east.size()];
    double from = lines.centreLine(strip - 1);
    double to = lines.centreLine(strip);
    if (Stream.of(polygon.getCoordinates()).noneMatch(c -> c.x > from && c.x < to)) {
      for (int i = 0; i < partners.length; i++) {
        partners[i] = i; // no corner in between: edges run from line to line
      }
      return partners;
    }
    Envelope between =
        new Envelope(
            from,
            to,
            polygon.getEnvelopeInternal().getMinY() - 1,
            polygon.getEnvelopeInternal().getMaxY() + 1);
    GeometryFactory factory = polygon.getFactory();
    Geometry ground = SnappedOverlay.intersection(polygon, factory.toGeometry(between));
    int[] ofWest = parts(ground, west);
    int[] ofEast = parts(ground, east);
    for (int i = 0; i < partners.length; i++) {
      int only = only(ofWest, ofEast[i]);
      partners[i] = only(ofEast, ofEast[i]) < 0 ? -1 : only;
    }
    return partners;
  }

  /** The number of the region part that each lane borders. */
  private static int[] parts(Geometry ground, List<LaneSegment> lanes) {
    int[] parts = new int[lanes.size()];
    for (int i = 0; i < parts.length; i++) {
      Coordinate middle = new Coordinate(lanes.get(i).from());
      middle.y = (middle.y + lanes.get(i).to().y) / 2;
      Geometry point = ground.getFactory().createPoint(middle);
      double nearest = Double.POSITIVE_INFINITY;
      for (int part = 0; part < ground.getNumGeometries(); part++) {
        double distance = ground.getGeometryN(part).distance(point);
        if (distance < nearest) {
          nearest = distance;
          parts[i] = part;
        }
      }
    }
    return parts;
  }

  /** The only index of a number; -1 if it occurs never or several times. */
  private static int only(int[] numbers, int wanted) {
    int found = -1;
    for (int i = 0; i < numbers.length; i++) {
      if (numbers[i] == wanted) {
        if (found >= 0) {
          return -1;
        }
        found = i;
      }
    }
    return found;
  }

  /**
   * Its lanes in the order and direction in which they are driven.
   *
   * @param way traversal, below {@link #TRAVERSALS}: bit 0 set starts in the east, bit 1 set starts
   *     southward
   */
  List<LaneSegment> traversal(int way) {
    List<LaneSegment> driven = new ArrayList<>();
    for (int i = 0; i < lanes.size(); i++) {
      LaneSegment lane = lanes.get((way & 1) == 0 ? i : lanes.size() - 1 - i);
      boolean isNorthward = (way & 2) == 0 == (i % 2 == 0);
      driven.add(isNorthward ? lane : lane.reversed());
    }
    return driven;
  }

  /** Its entry point. */
  Coordinate entry(int way) {
    LaneSegment first = lanes.get((way & 1) == 0 ? 0 : lanes.size() - 1);
    return (way & 2) == 0 ? first.from() : first.to();
  }

  /** Its exit point. */
  Coordinate exit(int way) {
    LaneSegment last = lanes.get((way & 1) == 0 ? lanes.size() - 1 : 0);
    boolean isNorthward = (way & 2) == 0 == (lanes.size() % 2 == 1);
    return isNorthward ? last.to() : last.from();
  }
}
