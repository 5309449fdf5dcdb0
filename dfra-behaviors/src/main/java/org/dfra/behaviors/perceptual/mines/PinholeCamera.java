package org.dfra.behaviors.perceptual.mines;

import org.dfra.geometry.Transform;
import org.jspecify.annotations.Nullable;

/**
 * Where a camera on a robot sees what lies around the robot. The ground is the plane z = 0 of the
 * robot's base, whose x is forward and whose y is to the left.
 *
 * @param mount of the camera on the base: takes coordinates in its frame, x along its axis, y left,
 *     z up, to those in the base's
 * @param width of its images, pixels
 * @param height of its images, pixels
 * @param focalLength of its images, pixels
 */
record PinholeCamera(Transform mount, int width, int height, double focalLength) {

  private static final double NEAREST = 0.05; // metres before the lens

  /**
   * A place in an image.
   *
   * @param column from the left edge, pixels; may lie outside the image
   * @param row from the upper edge, pixels; may lie outside the image
   */
  record Pixel(double column, double row) {}

  /**
   * Where a point is seen.
   *
   * @param x forward of the base, metres
   * @param y to the left, metres
   * @param z above the ground, metres
   * @return null if it is beside or behind the camera
   */
  @Nullable Pixel project(double x, double y, double z) {
    double[] m = matrix();
    double dx = x - mount.x();
    double dy = y - mount.y();
    double dz = z - mount.z();
    double ahead = m[0] * dx + m[3] * dy + m[6] * dz;
    if (ahead < NEAREST) {
      return null;
    }
    double left = m[1] * dx + m[4] * dy + m[7] * dz;
    double up = m[2] * dx + m[5] * dy + m[8] * dz;
    return new Pixel(
        width / 2.0 - focalLength * left / ahead, height / 2.0 - focalLength * up / ahead);
  }

  /**
   * What a pixel shows, if that is so high above the ground.
   *
   * @param z metres, below the camera
   * @return null if the pixel shows what is above the horizon
   */
  @Nullable GroundPoint backProject(Pixel pixel, double z) {
    double[] m = matrix();
    double left = (width / 2.0 - pixel.column()) / focalLength;
    double up = (height / 2.0 - pixel.row()) / focalLength;
    double down = m[6] + m[7] * left + m[8] * up;
    double away = (z - mount.z()) / down;
    if (!(down < 0 && away > 0)) {
      return null;
    }
    return new GroundPoint(
        mount.x() + away * (m[0] + m[1] * left + m[2] * up),
        mount.y() + away * (m[3] + m[4] * left + m[5] * up));
  }

  /** Of the mount's turn, row by row: takes a direction in the camera's frame to the base's. */
  private double[] matrix() {
    double w = mount.qw();
    double x = mount.qx();
    double y = mount.qy();
    double z = mount.qz();
    return new double[] {
      1 - 2 * (y * y + z * z),
      2 * (x * y - w * z),
      2 * (x * z + w * y),
      2 * (x * y + w * z),
      1 - 2 * (x * x + z * z),
      2 * (y * z - w * x),
      2 * (x * z - w * y),
      2 * (y * z + w * x),
      1 - 2 * (x * x + y * y)
    };
  }
}
