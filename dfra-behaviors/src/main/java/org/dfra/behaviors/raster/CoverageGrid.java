package org.dfra.behaviors.raster;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.dfra.behaviors.raster.RasterPlan.Coverage;
import org.dfra.geometry.LocalPosition;
import org.locationtech.jts.geom.Coordinate;
import org.locationtech.jts.geom.Envelope;
import org.locationtech.jts.geom.Polygon;

/**
 * Counts the passes over small squares. It uses a grid, since the outline of the seen area does not
 * contain the number of passes, and since its time grows only with the path length: 5000 points
 * take some milliseconds, with any number of self-crossings.
 */
final class CoverageGrid {

  /** Squares per swath for counting. */
  static final double FINENESS = 40;

  /** Squares per swath for display. */
  static final double COARSENESS = 12;

  private static final double MOST_CELLS = 4e6;

  /** A region nowhere thinner than a square has more, even of coarse ones: 144. */
  private static final double LEAST_CELLS = 100;

  private final double range;
  private final double side;
  private final double west;
  private final double south;
  private final int columns;
  private final int rows;
  private final boolean[] isInside; // by the centre of the square, see fillAlong
  private final double[] lastSeen; // metres driven until then
  private final byte[] passes; // 0, 1, or 2 for more

  /**
   * @param swath width, metres
   * @param fineness squares per swath, limited by memory
   */
  CoverageGrid(Polygon polygon, double swath, double fineness) {
    if (!(swath > 0 && Double.isFinite(swath))) {
      throw new IllegalArgumentException(
          "a swath of " + swath + " m is not above 0; give a greater one");
    }
    Envelope bounds = polygon.getEnvelopeInternal();
    this.range = swath / 2;
    this.side =
        Math.max(
            Math.min(swath, Math.sqrt(polygon.getArea())) / fineness,
            Math.sqrt(bounds.getArea() / MOST_CELLS));
    this.west = bounds.getMinX();
    this.south = bounds.getMinY();
    this.columns = (int) Math.ceil(bounds.getWidth() / side);
    this.rows = (int) Math.ceil(bounds.getHeight() / side);
    this.isInside = new boolean[columns * rows];
    this.lastSeen = new double[isInside.length];
    this.passes = new byte[isInside.length];
    Coordinate[] ring = polygon.getExteriorRing().getCoordinates();
    long inside = 0;
    for (int row = 0; row < rows; row++) {
      inside += fill(row, ring);
    }
    if (inside < Math.max(LEAST_CELLS, polygon.getArea() / (side * side) / 2)) {
      fillAlong(ring);
    }
  }

  /** Number of squares of this row that are inside. */
  private int fill(int row, Coordinate[] ring) {
    int inside = 0;
    double y = south + (row + 0.5) * side;
    double[] crossings = new double[ring.length];
    int count = 0;
    for (int i = 1; i < ring.length; i++) {
      Coordinate a = ring[i - 1];
      Coordinate b = ring[i];
      if (a.y < y != b.y < y) {
        crossings[count++] = a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x);
      }
    }
    Arrays.sort(crossings, 0, count);
    for (int i = 1; i < count; i += 2) {
      int from = Math.max(0, (int) Math.ceil((crossings[i - 1] - west) / side - 0.5));
      int to = Math.min(columns, (int) Math.ceil((crossings[i] - west) / side - 0.5));
      if (to > from) {
        Arrays.fill(isInside, row * columns + from, row * columns + to, true);
        inside += to - from;
      }
    }
    return inside;
  }

  /** A region so thin that it contains no square's centre consists of those along its outline. */
  private void fillAlong(Coordinate[] ring) {
    for (int i = 1; i < ring.length; i++) {
      Coordinate a = ring[i - 1];
      Coordinate b = ring[i];
      int steps = (int) Math.ceil(2 * a.distance(b) / side);
      for (int step = 0; step <= steps; step++) {
        double share = steps == 0 ? 0 : (double) step / steps;
        int column = (int) ((a.x + share * (b.x - a.x) - west) / side);
        int row = (int) ((a.y + share * (b.y - a.y) - south) / side);
        isInside[Math.min(rows - 1, row) * columns + Math.min(columns - 1, column)] = true;
      }
    }
  }

  Coverage of(List<LocalPosition> driven) {
    drive(driven);
    long inside = 0;
    long once = 0;
    long again = 0;
    for (int i = 0; i < isInside.length; i++) {
      if (isInside[i]) {
        inside++;
        once += passes[i] > 0 ? 1 : 0;
        again += passes[i] > 1 ? 1 : 0;
      }
    }
    return new Coverage((double) once / inside, (double) again / inside, side);
  }

  CoverageMap map(List<LocalPosition> driven) {
    drive(driven);
    List<List<Integer>> map = new ArrayList<>();
    for (int row = 0; row < rows; row++) {
      List<Integer> cells = new ArrayList<>();
      for (int at = row * columns; at < (row + 1) * columns; at++) {
        cells.add(isInside[at] ? (int) passes[at] : CoverageMap.OUTSIDE);
      }
      map.add(cells);
    }
    return new CoverageMap(west, south, side, map);
  }

  private void drive(List<LocalPosition> driven) {
    Arrays.fill(lastSeen, Double.NEGATIVE_INFINITY);
    Arrays.fill(passes, (byte) 0);
    double odometer = 0;
    for (int i = 0; i < driven.size(); i++) {
      LocalPosition from = driven.get(Math.max(0, i - 1));
      LocalPosition to = driven.get(i);
      double length = Math.hypot(to.east() - from.east(), to.north() - from.north());
      see(from, to, length, odometer);
      odometer += length;
    }
  }

  private void see(LocalPosition from, LocalPosition to, double length, double odometer) {
    Envelope reach = new Envelope(from.east(), to.east(), from.north(), to.north());
    reach.expandBy(range);
    int firstColumn = Math.max(0, (int) Math.floor((reach.getMinX() - west) / side));
    int lastColumn = Math.min(columns - 1, (int) Math.floor((reach.getMaxX() - west) / side));
    int firstRow = Math.max(0, (int) Math.floor((reach.getMinY() - south) / side));
    int lastRow = Math.min(rows - 1, (int) Math.floor((reach.getMaxY() - south) / side));
    double alongEast = length > 0 ? (to.east() - from.east()) / length : 1;
    double alongNorth = length > 0 ? (to.north() - from.north()) / length : 0;
    for (int row = firstRow; row <= lastRow; row++) {
      double north = south + (row + 0.5) * side - from.north();
      for (int column = firstColumn; column <= lastColumn; column++) {
        int at = row * columns + column;
        double east = west + (column + 0.5) * side - from.east();
        double across = east * alongNorth - north * alongEast;
        double half = Math.sqrt(range * range - across * across); // NaN where out of view
        double along = east * alongEast + north * alongNorth;
        double enters = Math.max(0, along - half);
        double leaves = Math.min(length, along + half);
        if (isInside[at] && enters <= leaves) {
          see(at, odometer + enters, odometer + leaves);
        }
      }
    }
  }

  private void see(int at, double from, double to) {
    if (from - lastSeen[at] > 2 * range) {
      passes[at] = (byte) Math.min(2, passes[at] + 1);
    }
    lastSeen[at] = to;
  }
}
