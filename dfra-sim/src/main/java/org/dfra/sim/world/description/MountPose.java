package org.dfra.sim.world.description;

/**
 * Where a device stands on what carries it, and how it is turned: first roll about x, then pitch
 * about y, then yaw about z, each about an axis of what carries it.
 *
 * @param x forward, metres
 * @param y to the left, metres
 * @param z up, metres; on a robot above what the robot stands on
 * @param roll radians, left side up is +
 * @param pitch radians, nose down is +
 * @param yaw radians, to the left is +
 */
public record MountPose(double x, double y, double z, double roll, double pitch, double yaw) {

  /** In the middle of what carries it, and not turned. */
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

  /** Not turned. */
  public static MountPose at(double x, double y, double z) {
    return new MountPose(x, y, z, 0, 0, 0);
  }
}
