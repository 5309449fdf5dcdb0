package org.dfra.behaviors.perceptual.mines;

import org.dfra.behaviors.perceptual.mines.MineObservation.GroundPoint;
import org.dfra.geometry.Transform;
import org.jspecify.annotations.Nullable;

/**
 * Projection between a robot's surroundings and its camera's image. The ground is the plane z = 0
 * of the robot's base, whose x is forward and whose y is to the left.
 *
 * @param mount of the camera on the base: transforms coordinates in its frame, x along its axis, y
 *     left, z up, to the base's
 * @param width of its images, pixels
 * @param height of its images, pixels
 * @param focalLength of its images, pixels
 */
record PinholeCamera(Transform mount, int width, int height, double focalLength) {

  private static final double NEAREST = 0.05; // metres in front of the lens

  /**
   * A point in an image.
   *
   * @param column from the left edge, pixels; may lie outside the image
   * @param row from the upper edge, pixels; may lie outside the image
   */
  record Pixel(double column, double row) {}

  /**
   * Projects a point.
   *
   * @param x forward of the base, metres
   * @param y to the left, metres
   * @param z above the ground, metres
   * @return null if it is not in front of the camera
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
   * Back-projects a pixel to a plane at a given height above the ground.
   *
   * @param z metres, below the camera
   * @return null if the pixel is above the horizon
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

  /** Rotation matrix of the mount, row by row: from the camera's frame to the base's. */
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
