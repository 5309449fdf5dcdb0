package org.dfra.sim.world;

import org.dfra.sim.world.description.DeviceDescription.MountPose;
import org.dfra.sim.world.shape.MutableTransform;
import org.jspecify.annotations.Nullable;

/**
 * Computes the pose of a device, mounted on its robot or on the robot's pan-tilt head. Confined to
 * the world's monitor.
 */
final class DeviceMount {

  private final VehicleBody body;
  private final MutableTransform mount;
  private final @Nullable MutableTransform foot;
  private final @Nullable SimulatedPanTilt head;
  private final MutableTransform turned = new MutableTransform();
  private final MutableTransform result = new MutableTransform();

  /**
   * @param mount of the device on the robot, or on the head
   * @param foot mount of the head on the robot; null without a head
   */
  DeviceMount(
      VehicleBody body,
      MountPose mount,
      @Nullable MountPose foot,
      @Nullable SimulatedPanTilt head) {
    this.body = body;
    this.mount = pose(mount);
    this.foot = foot == null ? null : pose(foot);
    this.head = head;
  }

  private static MutableTransform pose(MountPose mount) {
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

  /** Pose of the device's frame in the world; the next call overwrites it. */
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
