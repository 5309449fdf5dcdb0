package org.dfra.sim.world;

import org.dfra.sim.world.description.MountPose;
import org.dfra.sim.world.shape.MutableTransform;
import org.jspecify.annotations.Nullable;

/** Where a device is: on its robot, or on a pan-tilt head of it. Confined to the monitor. */
final class DeviceMount {

  private final VehicleBody body;
  private final MutableTransform mount;
  private final @Nullable MutableTransform foot;
  private final @Nullable SimulatedPanTilt head;
  private final MutableTransform turned = new MutableTransform();
  private final MutableTransform result = new MutableTransform();

  /**
   * @param mount where the device is on the robot, or on the head
   * @param foot where the head is on the robot; null with no head
   */
  DeviceMount(
      VehicleBody body,
      MountPose mount,
      @Nullable MountPose foot,
      @Nullable SimulatedPanTilt head) {
    this.body = body;
    this.mount = stance(mount);
    this.foot = foot == null ? null : stance(foot);
    this.head = head;
  }

  private static MutableTransform stance(MountPose mount) {
    MutableTransform transform = new MutableTransform();
    transform.set(
        mount.x(),
        mount.y(),
        mount.z(),
        mount.roll(),
        mount.pitch(),
        StrictMath.cos(mount.yaw()),
        StrictMath.sin(mount.yaw()));
    return transform;
  }

  VehicleBody body() {
    return body;
  }

  /** Where the device's frame stands in the world; the next call overwrites it. */
  MutableTransform at(double[] row) {
    body.transformAt(row, result);
    if (head != null && foot != null) {
      result.compose(result, foot);
      head.apply(row, turned);
      result.compose(result, turned);
    }
    result.compose(result, mount);
    return result;
  }
}
