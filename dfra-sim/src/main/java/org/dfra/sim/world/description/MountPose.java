package org.dfra.sim.world.description;

/**
 * Pose of a device on its carrier: rotated first by roll about x, then by pitch about y, then by
 * yaw about z, each about an axis of the carrier.
 *
 * @param x forward, metres
 * @param y to the left, metres
 * @param z up, metres; on a robot above its base
 * @param roll radians, left side up is +
 * @param pitch radians, nose down is +
 * @param yaw radians, to the left is +
 */
public record MountPose(double x, double y, double z, double roll, double pitch, double yaw) {

  /** At the origin of its carrier, not rotated. */
  public static final MountPose MIDDLE = new MountPose(0, 0, 0, 0, 0, 0);

  public MountPose {
    if (!Double.isFinite(x + y + z + roll + pitch + yaw)) {
      throw new IllegalArgumentException(
          "the mount ("
              + x
              + ", "
              + y
              + ", "
              + z
              + ") m, ("
              + roll
              + ", "
              + pitch
              + ", "
              + yaw
              + ") rad is not finite");
    }
  }

  /** Not rotated. */
  public static MountPose at(double x, double y, double z) {
    return new MountPose(x, y, z, 0, 0, 0);
  }
}
