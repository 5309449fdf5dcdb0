package org.dfra.geometry;

import java.io.Serializable;

/**
 * The pose of one frame in another, its parent: maps coordinates in the frame to coordinates in the
 * parent, by a rotation followed by a translation. Frames are right-handed, x forward, y left, z
 * up.
 *
 * @param x forward offset in the parent frame, metres
 * @param y offset to the left in the parent frame, metres
 * @param z upward offset in the parent frame, metres
 * @param qw real part of the rotation's unit quaternion
 * @param qx its part along x
 * @param qy its part along y
 * @param qz its part along z
 */
public record Transform(double x, double y, double z, double qw, double qx, double qy, double qz)
    implements Serializable {

  /** The frame coincides with its parent. */
  public static final Transform IDENTITY = new Transform(0, 0, 0, 1, 0, 0, 0);

  /** Accepted deviation of the quaternion's norm from 1; the quaternion is normalized. */
  private static final double TOLERANCE = 1e-6;

  public Transform {
    double length = Math.sqrt(qw * qw + qx * qx + qy * qy + qz * qz);
    if (!(Math.abs(length - 1) <= TOLERANCE)) {
      throw new IllegalArgumentException(
          "the quaternion ("
              + qw
              + ", "
              + qx
              + ", "
              + qy
              + ", "
              + qz
              + ") has length "
              + length
              + "; scale it to 1");
    }
    if (!Double.isFinite(x + y + z)) {
      throw new IllegalArgumentException(
          "the offset (" + x + ", " + y + ", " + z + ") m is not finite");
    }
    qw /= length;
    qx /= length;
    qy /= length;
    qz /= length;
  }

  /** A translation only. */
  public static Transform translation(double x, double y, double z) {
    return new Transform(x, y, z, 1, 0, 0, 0);
  }

  /**
   * A translation and a rotation. The rotation consists of three, each about an axis of the parent
   * frame: first roll about x, then pitch about y, then yaw about z. (The same as yaw, pitch, roll,
   * each about the rotated axis.)
   *
   * @param x forward offset in the parent frame, metres
   * @param y offset to the left in the parent frame, metres
   * @param z upward offset in the parent frame, metres
   * @param roll angle about x, radians, left side up is +
   * @param pitch angle about y, radians, nose down is +
   * @param yaw angle about z, radians, counter-clockwise seen from above is +
   */
  public static Transform of(double x, double y, double z, double roll, double pitch, double yaw) {
    double cr = Math.cos(roll / 2);
    double sr = Math.sin(roll / 2);
    double cp = Math.cos(pitch / 2);
    double sp = Math.sin(pitch / 2);
    double cy = Math.cos(yaw / 2);
    double sy = Math.sin(yaw / 2);
    return new Transform(
        x,
        y,
        z,
        cr * cp * cy + sr * sp * sy,
        sr * cp * cy - cr * sp * sy,
        cr * sp * cy + sr * cp * sy,
        cr * cp * sy - sr * sp * cy);
  }

  /** Angle about x, radians, −π to π; see {@link #of}. */
  public double roll() {
    return Math.atan2(2 * (qw * qx + qy * qz), 1 - 2 * (qx * qx + qy * qy));
  }

  /** Angle about y, radians, −π/2 to π/2; see {@link #of}. */
  public double pitch() {
    return Math.asin(Math.max(-1, Math.min(1, 2 * (qw * qy - qz * qx))));
  }

  /** Angle about z, radians, −π to π; see {@link #of}. */
  public double yaw() {
    return Math.atan2(2 * (qw * qz + qx * qy), 1 - 2 * (qy * qy + qz * qz));
  }
}
