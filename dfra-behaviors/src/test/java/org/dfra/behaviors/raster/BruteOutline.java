package org.dfra.behaviors.raster;

import java.util.Arrays;
import java.util.DoubleSummaryStatistics;
import java.util.List;
import java.util.Random;
import java.util.stream.DoubleStream;
import org.dfra.behaviors.raster.RasterPlan.Lane;
import org.dfra.geometry.LocalPosition;

/** An outline that knows no library: what is inside is found by counting edges to the east. */
final class BruteOutline {

  private final double[][] corners;

  BruteOutline(Region region) {
    corners =
        region.corners().stream()
            .map(region.frame()::toLocal)
            .map(at -> new double[] {at.east(), at.north()})
            .toArray(double[][]::new);
  }

  double perimeter() {
    double length = 0;
    for (int i = 0; i < corners.length; i++) {
      double[] next = corners[(i + 1) % corners.length];
      length += Math.hypot(next[0] - corners[i][0], next[1] - corners[i][1]);
    }
    return length;
  }

  double area() {
    double twice = 0;
    for (int i = 0; i < corners.length; i++) {
      double[] next = corners[(i + 1) % corners.length];
      twice += corners[i][0] * next[1] - corners[i][1] * next[0];
    }
    return Math.abs(twice) / 2;
  }

  /** A corner, a point of an edge or one inside; beside a point of the path if one is given. */
  double[] point(Random random, List<LocalPosition> path, double around) {
    while (true) {
      int pick = random.nextInt(4);
      int i = random.nextInt(corners.length);
      double[] a = corners[i];
      double[] b = corners[(i + 1) % corners.length];
      double share = pick == 0 ? 0 : random.nextDouble();
      double[] point = {a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1])};
      if (pick < 2) {
        return point;
      }
      if (pick == 2) {
        LocalPosition near = path.get(random.nextInt(path.size()));
        double angle = random.nextDouble() * 2 * Math.PI;
        double far = around * (0.9 + 0.3 * random.nextDouble());
        point =
            new double[] {
              near.east() + far * Math.cos(angle), near.north() + far * Math.sin(angle)
            };
      } else {
        double[] c = corners[random.nextInt(corners.length)];
        double r = Math.sqrt(random.nextDouble());
        double s = random.nextDouble();
        for (int k = 0; k < 2; k++) {
          point[k] = (1 - r) * a[k] + r * (1 - s) * b[k] + r * s * c[k];
        }
      }
      if (holds(point[0], point[1])) {
        return point;
      }
    }
  }

  /** A point of the box that it just fits in; whether it is inside, the lot decides. */
  double[] around(Random random) {
    double[] point = new double[2];
    for (int k = 0; k < 2; k++) {
      int axis = k;
      DoubleSummaryStatistics all =
          Arrays.stream(corners).mapToDouble(corner -> corner[axis]).summaryStatistics();
      point[k] = all.getMin() + (all.getMax() - all.getMin()) * random.nextDouble();
    }
    return point;
  }

  boolean holds(double x, double y) {
    boolean isInside = false;
    for (int i = 0; i < corners.length; i++) {
      double[] a = corners[i];
      double[] b = corners[(i + 1) % corners.length];
      if (a[1] > y != b[1] > y && x < a[0] + (y - a[1]) / (b[1] - a[1]) * (b[0] - a[0])) {
        isInside = !isInside;
      }
    }
    return isInside;
  }

  /**
   * How far a straight way leaves the outline, metres. It can do so between two places at which it
   * meets the outline only, so the middle of each such part is looked at.
   */
  double strays(LocalPosition from, LocalPosition to) {
    double dx = to.east() - from.east();
    double dy = to.north() - from.north();
    DoubleStream.Builder meets = DoubleStream.builder().add(0).add(1);
    for (int i = 0; i < corners.length; i++) {
      double[] a = corners[i];
      double[] b = corners[(i + 1) % corners.length];
      double cross = dx * (b[1] - a[1]) - dy * (b[0] - a[0]);
      double at =
          ((a[0] - from.east()) * (b[1] - a[1]) - (a[1] - from.north()) * (b[0] - a[0])) / cross;
      if (at > 0 && at < 1) {
        meets.add(at);
      }
    }
    double[] places = meets.build().sorted().toArray();
    double most = Math.max(outside(from.east(), from.north()), outside(to.east(), to.north()));
    for (int i = 1; i < places.length; i++) {
      double middle = (places[i - 1] + places[i]) / 2;
      most = Math.max(most, outside(from.east() + middle * dx, from.north() + middle * dy));
    }
    return most;
  }

  /** The distance to the outline from outside, metres; 0 inside. */
  private double outside(double x, double y) {
    if (holds(x, y)) {
      return 0;
    }
    double least = Double.POSITIVE_INFINITY;
    for (int i = 0; i < corners.length; i++) {
      double[] b = corners[(i + 1) % corners.length];
      least = Math.min(least, distance(x, y, corners[i][0], corners[i][1], b[0], b[1]));
    }
    return least;
  }

  /** The distance of a point from a lane, metres. */
  static double distance(double[] point, Lane lane) {
    LocalPosition from = lane.from();
    LocalPosition to = lane.to();
    return distance(point[0], point[1], from.east(), from.north(), to.east(), to.north());
  }

  private static double distance(double x, double y, double ax, double ay, double bx, double by) {
    double dx = bx - ax;
    double dy = by - ay;
    double square = dx * dx + dy * dy;
    double share = square == 0 ? 0 : ((x - ax) * dx + (y - ay) * dy) / square;
    share = Math.max(0, Math.min(1, share));
    double east = x - ax - share * dx;
    double north = y - ay - share * dy;
    return Math.sqrt(east * east + north * north); // hypot takes five times as long, for nothing
  }

  @Override
  public String toString() {
    return Arrays.deepToString(corners);
  }
}
