package org.dfra.sim.world;

import org.dfra.sim.world.description.Mount;
import org.dfra.sim.world.shape.Stance;
import org.jspecify.annotations.Nullable;

/** Where a device is: on its robot, or on a pan-tilt head of it. Confined to the monitor. */
final class Rig {

  private final Body body;
  private final Stance mount;
  private final @Nullable Stance foot;
  private final @Nullable Head head;
  private final Stance turned = new Stance();
  private final Stance result = new Stance();

  /**
   * @param mount where the device is on the robot, or on the head
   * @param foot where the head is on the robot; null with no head
   */
  Rig(Body body, Mount mount, @Nullable Mount foot, @Nullable Head head) {
    this.body = body;
    this.mount = stance(mount);
    this.foot = foot == null ? null : stance(foot);
    this.head = head;
  }

  private static Stance stance(Mount mount) {
    Stance stance = new Stance();
    stance.set(
        mount.x(),
        mount.y(),
        mount.z(),
        mount.roll(),
        mount.pitch(),
        StrictMath.cos(mount.yaw()),
        StrictMath.sin(mount.yaw()));
    return stance;
  }

  Body body() {
    return body;
  }

  /** Where the device's frame stands in the world; the next call overwrites it. */
  Stance at(double[] row) {
    body.stance(row, result);
    if (head != null && foot != null) {
      result.compose(result, foot);
      head.turn(row, turned);
      result.compose(result, turned);
    }
    result.compose(result, mount);
    return result;
  }
}
