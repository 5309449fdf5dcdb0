package org.dfra.behaviors.raster;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.locationtech.jts.geom.Coordinate;
import org.locationtech.jts.geom.Envelope;
import org.locationtech.jts.geom.Geometry;
import org.locationtech.jts.geom.GeometryFactory;
import org.locationtech.jts.geom.Polygon;

/**
 * Lanes side by side, one in each of some strips in a row, that are driven to and fro without
 * anything in between. Where a notch begins or ends between two strips, so do cells. Source of the
 * idea: H. Choset and P. Pignon, "Coverage path planning: the boustrophedon cellular
 * decomposition", FSR 1997.
 *
 * @param lanes from west to east, each of them northward; at least one
 */
record Cell(List<Stroke> lanes) {

  /** How many ways there are to drive it: from either end, beginning at either end of a lane. */
  static final int WAYS = 4;

  /** The cells of a polygon, those that begin farther west first. */
  static List<Cell> of(Polygon polygon, LaneLines lines) {
    List<Cell> cells = new ArrayList<>();
    List<Cell> open = new ArrayList<>(); // one for each lane of the strip
    for (Stroke lane : lines.lanes(0)) {
      open.add(started(lane, cells));
    }
    for (int strip = 1; strip < lines.count(); strip++) {
      List<Cell> before = open;
      open = new ArrayList<>();
      int[] partners = partners(polygon, lines, strip);
      for (int i = 0; i < partners.length; i++) {
        Stroke lane = lines.lanes(strip).get(i);
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

  private static Cell started(Stroke lane, List<Cell> cells) {
    Cell cell = new Cell(new ArrayList<>(List.of(lane)));
    cells.add(cell);
    return cell;
  }

  /** For each lane of a strip, the one before it that leads to no other; -1 where there is none. */
  private static int[] partners(Polygon polygon, LaneLines lines, int strip) {
    List<Stroke> west = lines.lanes(strip - 1);
    List<Stroke> east = lines.lanes(strip);
    int[] partners = new int[east.size()];
    double from = lines.middle(strip - 1);
    double to = lines.middle(strip);
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
    Geometry ground = Cut.common(polygon, factory.toGeometry(between));
    int[] ofWest = parts(ground, west);
    int[] ofEast = parts(ground, east);
    for (int i = 0; i < partners.length; i++) {
      int only = only(ofWest, ofEast[i]);
      partners[i] = only(ofEast, ofEast[i]) < 0 ? -1 : only;
    }
    return partners;
  }

  /** The number of the part of the ground that each lane borders. */
  private static int[] parts(Geometry ground, List<Stroke> lanes) {
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

  /** The one place at which a number is; -1 if it is at none or several. */
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
   * @param way of {@link #WAYS}: the least bit set begins in the east, the next one set begins
   *     southward
   */
  List<Stroke> driven(int way) {
    List<Stroke> driven = new ArrayList<>();
    for (int i = 0; i < lanes.size(); i++) {
      Stroke lane = lanes.get((way & 1) == 0 ? i : lanes.size() - 1 - i);
      boolean isNorthward = (way & 2) == 0 == (i % 2 == 0);
      driven.add(isNorthward ? lane : lane.reversed());
    }
    return driven;
  }

  /** Where it is entered. */
  Coordinate entry(int way) {
    Stroke first = lanes.get((way & 1) == 0 ? 0 : lanes.size() - 1);
    return (way & 2) == 0 ? first.from() : first.to();
  }

  /** Where it is left. */
  Coordinate exit(int way) {
    Stroke last = lanes.get((way & 1) == 0 ? lanes.size() - 1 : 0);
    boolean isNorthward = (way & 2) == 0 == (lanes.size() % 2 == 1);
    return isNorthward ? last.to() : last.from();
  }
}
