package org.dfra.behaviors.raster;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.locationtech.jts.algorithm.Orientation;
import org.locationtech.jts.geom.Coordinate;
import org.locationtech.jts.geom.Polygon;

/**
 * Finds shortest paths inside a polygon. The shortest path between two points is straight, or bends
 * only at reflex corners; so it leads from one visible from the first point to one visible from the
 * other. It caches results. Confined to one thread.
 */
final class InteriorPathFinder {

  private final LineOfSight sight;
  private final Coordinate[] corners; // the reflex corners
  private final @Nullable ShortestPathTree[] rows; // by their first corner
  private final Map<Coordinate, int[]> seenFrom = new HashMap<>();
  private final int[][] neighbours; // the corners visible from each; null where not computed yet

  /** The shortest paths from one reflex corner to all. */
  private record ShortestPathTree(double[] length, int[] before) {}

  InteriorPathFinder(Polygon polygon) {
    this.sight = new LineOfSight(polygon);
    this.corners = corners(polygon.getExteriorRing().getCoordinates());
    this.rows = new ShortestPathTree[corners.length];
    this.neighbours = new int[corners.length][];
  }

  private static Coordinate[] corners(Coordinate[] ring) {
    int outside = Orientation.isCCW(ring) ? Orientation.CLOCKWISE : Orientation.COUNTERCLOCKWISE;
    List<Coordinate> corners = new ArrayList<>();
    int n = ring.length - 1;
    for (int i = 0; i < n; i++) {
      if (Orientation.index(ring[(i + n - 1) % n], ring[i], ring[i + 1]) == outside) {
        corners.add(ring[i]);
      }
    }
    return corners.toArray(new Coordinate[0]);
  }

  /** The length of the shortest path between two points of the polygon, metres. */
  double distance(Coordinate a, Coordinate b) {
    return sight.isClear(a, b) ? a.distance(b) : shortest(a, b).length;
  }

  /** The shortest path between two points of the polygon, both ends included. */
  List<Coordinate> path(Coordinate a, Coordinate b) {
    if (sight.isClear(a, b)) {
      return List.of(a, b);
    }
    CornerPath bridge = shortest(a, b);
    List<Coordinate> way = new ArrayList<>(List.of(b));
    int[] before = row(bridge.first).before;
    for (int at = bridge.last; at != bridge.first; at = before[at]) {
      way.add(0, corners[at]);
    }
    way.add(0, corners[bridge.first]);
    way.add(0, a);
    return way;
  }

  /** A path, by its first and its last corner. */
  private record CornerPath(int first, int last, double length) {}

  private CornerPath shortest(Coordinate a, Coordinate b) {
    CornerPath best = new CornerPath(-1, -1, Double.POSITIVE_INFINITY);
    int[] lasts = seen(b);
    for (int first : seen(a)) {
      double there = a.distance(corners[first]);
      if (there + corners[first].distance(b) >= best.length) {
        continue;
      }
      double[] onward = row(first).length;
      for (int last : lasts) {
        double length = there + onward[last] + corners[last].distance(b);
        if (length < best.length) {
          best = new CornerPath(first, last, length);
        }
      }
    }
    if (best.first < 0) {
      throw new IllegalStateException(a + " and " + b + " are not inside one polygon");
    }
    return best;
  }

  private int[] seen(Coordinate point) {
    return seenFrom.computeIfAbsent(point, this::look);
  }

  private int[] look(Coordinate point) {
    int[] seen = new int[corners.length];
    int count = 0;
    for (int i = 0; i < corners.length; i++) {
      if (sight.isClear(point, corners[i])) {
        seen[count++] = i;
      }
    }
    return Arrays.copyOf(seen, count);
  }

  /** By Dijkstra's algorithm. */
  private ShortestPathTree row(int start) {
    ShortestPathTree known = rows[start];
    if (known != null) {
      return known;
    }
    double[] length = new double[corners.length];
    int[] before = new int[corners.length];
    boolean[] isDone = new boolean[corners.length];
    Arrays.fill(length, Double.POSITIVE_INFINITY);
    length[start] = 0;
    for (int at = start; at >= 0; at = nearest(length, isDone)) {
      isDone[at] = true;
      if (neighbours[at] == null) {
        neighbours[at] = look(corners[at]);
      }
      for (int next : neighbours[at]) {
        double there = length[at] + corners[at].distance(corners[next]);
        if (there < length[next]) {
          length[next] = there;
          before[next] = at;
        }
      }
    }
    ShortestPathTree row = new ShortestPathTree(length, before);
    rows[start] = row;
    return row;
  }

  private static int nearest(double[] length, boolean[] isDone) {
    int nearest = -1;
    for (int i = 0; i < length.length; i++) {
      boolean isNearer = length[i] < (nearest < 0 ? Double.POSITIVE_INFINITY : length[nearest]);
      if (!isDone[i] && isNearer) {
        nearest = i;
      }
    }
    return nearest;
  }
}
