package org.dfra.behaviors.raster;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import org.dfra.behavior.GoalRefusedException;
import org.dfra.geometry.GeoPosition;
import org.dfra.geometry.LocalFrame;
import org.dfra.geometry.LocalPosition;

/** Regions of every kind, anywhere on the earth, drawn by a seed. */
final class RandomRegions {

  /** Kinds of outlines. */
  enum Kind {
    CONVEX,
    STAR,
    TANGLED,
    SKYLINE,
    SLIVER
  }

  private final Random random;

  RandomRegions(Random random) {
    this.random = random;
  }

  /** A region of that kind. What is drawn may cross itself; then another one is. */
  Region next(Kind kind) {
    LocalFrame frame =
        new LocalFrame(
            new GeoPosition(random.nextDouble() * 176 - 88, random.nextDouble() * 360 - 180, 0));
    while (true) {
      List<GeoPosition> corners = new ArrayList<>();
      for (double[] corner : outline(kind)) {
        corners.add(frame.toGeo(new LocalPosition(corner[0], corner[1], 0)));
      }
      try {
        return Region.of(corners);
      } catch (GoalRefusedException e) {
        // drawn again
      }
    }
  }

  private List<double[]> outline(Kind kind) {
    return switch (kind) {
      case CONVEX -> round(1);
      case STAR -> round(0.1 + 0.8 * random.nextDouble());
      case TANGLED -> untangled();
      case SKYLINE -> skyline();
      case SLIVER -> sliver();
    };
  }

  /** Corners around a middle; on an ellipse, or up to a share of the way from there to it. */
  private List<double[]> round(double least) {
    int n = 3 + random.nextInt(25);
    double[] angles = random.doubles(n, 0, 2 * Math.PI).sorted().toArray();
    double a = 3 + random.nextDouble() * 30;
    double b = 1 + random.nextDouble() * 30;
    double turn = random.nextDouble() * Math.PI;
    List<double[]> outline = new ArrayList<>();
    for (double angle : angles) {
      double radius = least + (1 - least) * random.nextDouble();
      double x = a * radius * Math.cos(angle);
      double y = b * radius * Math.sin(angle);
      outline.add(
          new double[] {
            x * Math.cos(turn) - y * Math.sin(turn), x * Math.sin(turn) + y * Math.cos(turn)
          });
    }
    return outline;
  }

  /** Points in any order, parts of which are turned round until no edges cross. */
  private List<double[]> untangled() {
    int n = 4 + random.nextInt(14);
    List<double[]> ring = new ArrayList<>();
    for (int i = 0; i < n; i++) {
      ring.add(new double[] {random.nextDouble() * 40, random.nextDouble() * 40});
    }
    boolean isCrossed = true;
    while (isCrossed) {
      isCrossed = false;
      for (int i = 0; i < n; i++) {
        for (int j = i + 2; j < n; j++) {
          if (cross(ring.get(i), ring.get(i + 1), ring.get(j), ring.get((j + 1) % n))) {
            Collections.reverse(ring.subList(i + 1, j + 1)); // makes it shorter, so it ends
            isCrossed = true;
          }
        }
      }
    }
    return ring;
  }

  private static boolean cross(double[] a, double[] b, double[] c, double[] d) {
    return a != d && side(a, b, c) * side(a, b, d) < 0 && side(c, d, a) * side(c, d, b) < 0;
  }

  private static double side(double[] a, double[] b, double[] c) {
    return Math.signum((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]));
  }

  /** Houses side by side and their cellars, with walls along and across the lanes. */
  private List<double[]> skyline() {
    boolean isLying = random.nextBoolean();
    int n = 1 + random.nextInt(8);
    List<double[]> tops = new ArrayList<>();
    List<double[]> bottoms = new ArrayList<>();
    double x = 0;
    for (int i = 0; i < n; i++) {
      double next = x + (random.nextBoolean() ? 1 + random.nextInt(6) : 6 * random.nextDouble());
      double top = 1 + random.nextInt(25);
      double bottom = -random.nextInt(12);
      tops.add(new double[] {x, top});
      tops.add(new double[] {next, top});
      bottoms.add(0, new double[] {x, bottom});
      bottoms.add(0, new double[] {next, bottom});
      x = next;
    }
    tops.addAll(bottoms);
    return isLying ? tops.stream().map(c -> new double[] {c[1], c[0]}).toList() : tops;
  }

  /** A narrow way along some random points. */
  private List<double[]> sliver() {
    double wide = 0.05 + 2 * random.nextDouble();
    List<double[]> left = new ArrayList<>();
    List<double[]> right = new ArrayList<>();
    double x = 0;
    double y = 0;
    double heading = random.nextDouble() * 2 * Math.PI;
    for (int i = 0; i < 2 + random.nextInt(5); i++) {
      left.add(new double[] {x - wide * Math.sin(heading), y + wide * Math.cos(heading)});
      right.add(0, new double[] {x, y});
      heading += random.nextGaussian() * 0.5;
      x += 15 * Math.cos(heading);
      y += 15 * Math.sin(heading);
    }
    left.addAll(right);
    return left;
  }
}
