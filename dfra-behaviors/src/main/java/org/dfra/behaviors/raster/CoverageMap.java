package org.dfra.behaviors.raster;

import java.util.ArrayList;
import java.util.List;

/**
 * Number of passes over each part of a region: squares in rows from south to north, in each row
 * from west to east.
 *
 * @param west side of the westernmost squares, in the region's frame, metres
 * @param south side of the southernmost squares, likewise
 * @param cellSize side of a square, metres
 * @param passes over the centre of each square: 0, 1, or 2 for more; {@link #OUTSIDE} where that is
 *     not in the region
 */
public record CoverageMap(double west, double south, double cellSize, List<List<Integer>> passes) {

  /** Marks a square outside the region. */
  public static final int OUTSIDE = -1;

  public CoverageMap {
    passes = passes.stream().map(List::copyOf).toList();
  }

  /**
   * Merges with another path over the same region.
   *
   * @param other of the same region and swath
   * @throws IllegalArgumentException if its squares are not in the same places
   */
  public CoverageMap and(CoverageMap other) {
    if (west != other.west
        || south != other.south
        || cellSize != other.cellSize
        || passes.size() != other.passes.size()
        || passes.get(0).size() != other.passes.get(0).size()) {
      throw new IllegalArgumentException(
          "coverage maps of different regions or swaths cannot be merged; make both with one plan"
              + " and one swath");
    }
    List<List<Integer>> both = new ArrayList<>();
    for (int row = 0; row < passes.size(); row++) {
      List<Integer> cells = new ArrayList<>();
      for (int column = 0; column < passes.get(row).size(); column++) {
        int here = passes.get(row).get(column);
        cells.add(
            here == OUTSIDE ? OUTSIDE : Math.min(2, here + other.passes.get(row).get(column)));
      }
      both.add(cells);
    }
    return new CoverageMap(west, south, cellSize, both);
  }

  /** Share of the region's squares that were seen, 0 to 1. */
  public double share() {
    long inside = 0;
    long seen = 0;
    for (List<Integer> row : passes) {
      for (int each : row) {
        inside += each == OUTSIDE ? 0 : 1;
        seen += each > 0 ? 1 : 0;
      }
    }
    return inside == 0 ? 0 : (double) seen / inside;
  }

  /** Side of the easternmost squares, in the region's frame, metres. */
  public double east() {
    return west + cellSize * passes.get(0).size();
  }

  /** Side of the northernmost squares, likewise. */
  public double north() {
    return south + cellSize * passes.size();
  }
}
