package org.dfra.sim.world.shape;

import java.util.Arrays;
import java.util.List;
import org.dfra.sim.world.shape.PlanarShape.Disc;

/**
 * Spatial index of obstacles: squares of equal size, each with the obstacles whose bounds overlap
 * it. Confined to one thread, since a search marks its results.
 */
public final class ObstacleIndex {

  private static final double CELL = 2; // metres
  private static final int MOST_CELLS = 1 << 20;

  private final StaticObstacle[] solids;
  private final double cell;
  private final double west;
  private final double south;
  private final int columns;
  private final int rows;
  private final int[][] cells; // numbers of obstacles, row by row from the south-west
  private final long[] seen; // by obstacle: the last search that found it
  private long searches;

  public ObstacleIndex(List<StaticObstacle> all) {
    solids = all.toArray(new StaticObstacle[0]);
    seen = new long[solids.length];
    double minEast = Double.POSITIVE_INFINITY;
    double minNorth = Double.POSITIVE_INFINITY;
    double maxEast = Double.NEGATIVE_INFINITY;
    double maxNorth = Double.NEGATIVE_INFINITY;
    for (StaticObstacle solid : solids) {
      Disc bounds = solid.bounds;
      minEast = Math.min(minEast, bounds.east() - bounds.radius());
      maxEast = Math.max(maxEast, bounds.east() + bounds.radius());
      minNorth = Math.min(minNorth, bounds.north() - bounds.radius());
      maxNorth = Math.max(maxNorth, bounds.north() + bounds.radius());
    }
    boolean isEmpty = solids.length == 0;
    west = isEmpty ? 0 : minEast;
    south = isEmpty ? 0 : minNorth;
    double width = isEmpty ? 0 : maxEast - minEast;
    double depth = isEmpty ? 0 : maxNorth - minNorth;
    cell = Math.max(CELL, Math.sqrt(width * depth / MOST_CELLS));
    columns = (int) (width / cell) + 1;
    rows = (int) (depth / cell) + 1;
    cells = new int[columns * rows][];
    Arrays.fill(cells, new int[0]);
    for (int i = 0; i < solids.length; i++) {
      put(i);
    }
  }

  private void put(int number) {
    Disc bounds = solids[number].bounds;
    int lastColumn = column(bounds.east() + bounds.radius());
    int lastRow = row(bounds.north() + bounds.radius());
    for (int r = row(bounds.north() - bounds.radius()); r <= lastRow; r++) {
      for (int c = column(bounds.east() - bounds.radius()); c <= lastColumn; c++) {
        int[] before = cells[r * columns + c];
        int[] after = Arrays.copyOf(before, before.length + 1);
        after[before.length] = number;
        cells[r * columns + c] = after;
      }
    }
  }

  private int column(double east) {
    return (int) Math.max(0, Math.min(columns - 1, Math.floor((east - west) / cell)));
  }

  private int row(double north) {
    return (int) Math.max(0, Math.min(rows - 1, Math.floor((north - south) / cell)));
  }

  /** Number of obstacles. */
  public int size() {
    return solids.length;
  }

  /** An obstacle by its number. */
  public StaticObstacle solid(int number) {
    return solids[number];
  }

  /**
   * Finds the obstacles whose bounds overlap a disc, each once.
   *
   * @param found receives their numbers; long enough for all obstacles
   * @return number of obstacles found
   */
  public int query(double east, double north, double radius, int[] found) {
    int count = 0;
    searches++;
    int firstColumn = column(east - radius);
    int lastColumn = column(east + radius);
    int lastRow = row(north + radius);
    for (int r = row(north - radius); r <= lastRow; r++) {
      for (int c = firstColumn; c <= lastColumn; c++) {
        for (int number : cells[r * columns + c]) {
          if (seen[number] != searches) {
            seen[number] = searches;
            Disc bounds = solids[number].bounds;
            double x = bounds.east() - east;
            double y = bounds.north() - north;
            double reach = radius + bounds.radius();
            if (x * x + y * y <= reach * reach) {
              found[count++] = number;
            }
          }
        }
      }
    }
    return count;
  }
}
