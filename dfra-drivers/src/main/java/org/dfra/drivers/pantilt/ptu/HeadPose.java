package org.dfra.drivers.pantilt.ptu;

import org.dfra.geometry.Transform;

/** Computes the pose of a pan-tilt head. */
final class HeadPose {

  private HeadPose() {}

  /**
   * The mount, then pan about its z axis, then tilt about the resulting y axis: transforms
   * coordinates from the head's frame to the frame in which the unit is mounted.
   *
   * @param mount the intersection of the axes, and the head's orientation at 0, 0
   * @param pan radians, to the left is +
   * @param tilt radians, up is +
   */
  static Transform of(Transform mount, double pan, double tilt) {
    Transform turn = Transform.of(0, 0, 0, 0, -tilt, pan); // pitch is + nose down
    double w = mount.qw();
    double x = mount.qx();
    double y = mount.qy();
    double z = mount.qz();
    return new Transform(
        mount.x(),
        mount.y(),
        mount.z(),
        w * turn.qw() - x * turn.qx() - y * turn.qy() - z * turn.qz(),
        w * turn.qx() + x * turn.qw() + y * turn.qz() - z * turn.qy(),
        w * turn.qy() - x * turn.qz() + y * turn.qw() + z * turn.qx(),
        w * turn.qz() + x * turn.qy() - y * turn.qx() + z * turn.qw());
  }
}
