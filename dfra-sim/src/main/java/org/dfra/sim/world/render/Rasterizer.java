package org.dfra.sim.world.render;

import java.util.Arrays;
import org.dfra.sim.world.shape.MutableTransform;

/**
 * Rasterises facets through a pinhole camera; each pixel keeps the nearest facet. The camera's
 * optical axis is its x axis; y is to the left and z up in the image.
 *
 * <p>A pixel's sample is taken at its centre. The inverse distance along x is linear in image
 * coordinates, so the depth test compares that. Mutable, confined to one thread.
 */
final class Rasterizer {

  private static final double NEAREST = 0.03; // metres
  private static final int MOST_CORNERS = 64;

  final int width;
  final int height;
  final double focal; // pixels
  final int[] samples;
  final float[] inverseDepth; // inverse metres; 0 where no object is
  final boolean[] shaded; // ground in shadow
  final boolean[] leafy; // objects with the rough texture of a hedge

  private final MutableTransform camera = new MutableTransform();
  private final double[] x = new double[MOST_CORNERS];
  private final double[] y = new double[MOST_CORNERS];
  private final double[] z = new double[MOST_CORNERS];
  private final double[] u = new double[MOST_CORNERS];
  private final double[] v = new double[MOST_CORNERS];
  private int corners;
  private double spanFrom;
  private double spanTo;

  /**
   * @param fieldOfView from the left edge to the right, radians
   */
  Rasterizer(int width, int height, double fieldOfView) {
    this.width = width;
    this.height = height;
    this.focal = width / 2.0 / StrictMath.tan(fieldOfView / 2);
    this.samples = new int[width * height];
    this.inverseDepth = new float[width * height];
    this.shaded = new boolean[width * height];
    this.leafy = new boolean[width * height];
  }

  void begin(MutableTransform from) {
    camera.set(from);
    Arrays.fill(samples, 0);
    Arrays.fill(inverseDepth, 0);
    Arrays.fill(shaded, false);
  }

  MutableTransform camera() {
    return camera;
  }

  /** Whether an object within a ball may be in the image, and larger than a third of a pixel. */
  boolean mayShow(double east, double north, double up, double radius) {
    double dx = east - camera.east;
    double dy = north - camera.north;
    double dz = up - camera.up;
    double ahead = dx * camera.xx + dy * camera.yx + dz * camera.zx;
    if (ahead < -radius || ahead > 0 && 6 * radius * focal < ahead) {
      return false;
    }
    double left = Math.abs(dx * camera.xy + dy * camera.yy + dz * camera.zy);
    double high = Math.abs(dx * camera.xz + dy * camera.yz + dz * camera.zz);
    double halfWidth = width / 2.0 / focal;
    double halfHeight = height / 2.0 / focal;
    return left - halfWidth * ahead < radius * (1 + halfWidth)
        && high - halfHeight * ahead < radius * (1 + halfHeight);
  }

  /** Sets a corner of the next facet, in the world; the first one clears the previous corners. */
  void corner(int i, double east, double north, double up) {
    double dx = east - camera.east;
    double dy = north - camera.north;
    double dz = up - camera.up;
    x[i] = dx * camera.xx + dy * camera.yx + dz * camera.zx;
    y[i] = dx * camera.xy + dy * camera.yy + dz * camera.zy;
    z[i] = dx * camera.xz + dy * camera.yz + dz * camera.zz;
    corners = i + 1;
  }

  /**
   * Fills the current facet with a sample, where no pixel is nearer.
   *
   * @param nx east of the unit vector out of it
   */
  void fill(double nx, double ny, double nz, int sample, boolean isLeafy) {
    // In the camera's frame the facet lies in n·p = d; so 1/x is (n·ray)/d along each ray (1, …).
    double a = nx * camera.xx + ny * camera.yx + nz * camera.zx;
    double b = nx * camera.xy + ny * camera.yy + nz * camera.zy;
    double c = nx * camera.xz + ny * camera.yz + nz * camera.zz;
    double d = a * x[0] + b * y[0] + c * z[0];
    if (d >= 0 || !project()) { // seen from behind, or edge-on
      return;
    }
    double perColumn = -b / (focal * d);
    double perRow = -c / (focal * d);
    double first = (a + (b * width + c * height) / (2 * focal)) / d; // at the upper left corner
    int lastRow = (int) Math.min(height - 1, Math.floor(bottom() - 0.5));
    for (int row = (int) Math.max(0, Math.ceil(top() - 0.5)); row <= lastRow; row++) {
      span(row + 0.5);
      int to = (int) Math.min(width - 1, Math.floor(spanTo - 0.5));
      int column = (int) Math.max(0, Math.ceil(spanFrom - 0.5));
      double near = first + perRow * (row + 0.5) + perColumn * (column + 0.5);
      for (int at = row * width + column; column <= to; column++, at++) {
        if (near > inverseDepth[at]) {
          inverseDepth[at] = (float) near;
          samples[at] = sample;
          leafy[at] = isLeafy;
        }
        near += perColumn;
      }
    }
  }

  /** Marks the ground under the current outline as shaded. */
  void shade() {
    if (!project()) {
      return;
    }
    int lastRow = (int) Math.min(height - 1, Math.floor(bottom() - 0.5));
    for (int row = (int) Math.max(0, Math.ceil(top() - 0.5)); row <= lastRow; row++) {
      span(row + 0.5);
      int to = (int) Math.min(width - 1, Math.floor(spanTo - 0.5));
      int from = (int) Math.max(0, Math.ceil(spanFrom - 0.5));
      if (from <= to) {
        Arrays.fill(shaded, row * width + from, row * width + to + 1, true);
      }
    }
  }

  /** Clips at the near plane and projects the rest into the image; false if nothing is left. */
  private boolean project() {
    int behind = 0;
    for (int i = 0; i < corners; i++) {
      behind += x[i] < NEAREST ? 1 : 0;
    }
    if (behind == corners) {
      return false;
    }
    if (behind > 0) {
      cut();
    }
    for (int i = 0; i < corners; i++) {
      u[i] = width / 2.0 - focal * y[i] / x[i];
      v[i] = height / 2.0 - focal * z[i] / x[i];
    }
    return true;
  }

  /** Clips at the near plane, corner by corner; u and v are scratch space until then. */
  private void cut() {
    int count = 0;
    double[] retainedX = new double[MOST_CORNERS];
    for (int i = 0; i < corners; i++) {
      int next = (i + 1) % corners;
      if (x[i] >= NEAREST) {
        retainedX[count] = x[i];
        u[count] = y[i];
        v[count++] = z[i];
      }
      if (x[i] >= NEAREST != x[next] >= NEAREST) {
        double part = (NEAREST - x[i]) / (x[next] - x[i]);
        retainedX[count] = NEAREST;
        u[count] = y[i] + part * (y[next] - y[i]);
        v[count++] = z[i] + part * (z[next] - z[i]);
      }
    }
    System.arraycopy(retainedX, 0, x, 0, count);
    System.arraycopy(u, 0, y, 0, count);
    System.arraycopy(v, 0, z, 0, count);
    corners = count;
  }

  private double top() {
    double top = v[0];
    for (int i = 1; i < corners; i++) {
      top = Math.min(top, v[i]);
    }
    return top;
  }

  private double bottom() {
    double bottom = v[0];
    for (int i = 1; i < corners; i++) {
      bottom = Math.max(bottom, v[i]);
    }
    return bottom;
  }

  /** The intersections of the edges with a row. */
  private void span(double row) {
    spanFrom = Double.POSITIVE_INFINITY;
    spanTo = Double.NEGATIVE_INFINITY;
    int last = corners - 1;
    for (int i = 0; i < corners; last = i++) {
      if (v[i] <= row != v[last] <= row) {
        double at = u[last] + (row - v[last]) / (v[i] - v[last]) * (u[i] - u[last]);
        spanFrom = Math.min(spanFrom, at);
        spanTo = Math.max(spanTo, at);
      }
    }
  }
}
