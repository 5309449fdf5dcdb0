package org.dfra.sim.world;

import java.time.Instant;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;

/**
 * The true state of a world, which no robot knows: for reports and tests. Any thread may call it.
 */
public final class GroundTruth {

  private final World world;

  GroundTruth(World world) {
    this.world = world;
  }

  /**
   * The true pose of a robot.
   *
   * @throws IllegalArgumentException if there is no robot of that name
   */
  public GroundTruthPose pose(String robot, Instant time) {
    VehicleBody body = world.robot(robot).body();
    synchronized (world.monitor()) {
      long step = world.stepAt(time);
      return pose(body, world.row(step), world.instant(step));
    }
  }

  /** The true poses of all robots, by name. */
  public Map<String, GroundTruthPose> poses(Instant time) {
    synchronized (world.monitor()) {
      long step = world.stepAt(time);
      double[] row = world.row(step);
      Map<String, GroundTruthPose> poses = new TreeMap<>();
      for (VehicleBody body : world.bodies()) {
        poses.put(body.vehicle.name(), pose(body, row, world.instant(step)));
      }
      return poses;
    }
  }

  private static GroundTruthPose pose(VehicleBody body, double[] row, Instant time) {
    int at = body.offset;
    return new GroundTruthPose(
        time,
        row[at + VehicleBody.EAST],
        row[at + VehicleBody.NORTH],
        row[at + VehicleBody.UP],
        row[at + VehicleBody.ROLL],
        row[at + VehicleBody.PITCH],
        Math.IEEEremainder(row[at + VehicleBody.YAW], 2 * Math.PI),
        row[at + VehicleBody.EASTWARD],
        row[at + VehicleBody.NORTHWARD],
        row[at + VehicleBody.UPWARD],
        row[at + VehicleBody.RATE]);
  }

  /**
   * The mines visible in a camera's image, with their position in it; at least one pixel each.
   *
   * @throws IllegalArgumentException if there is no such robot or camera
   */
  public List<MineSighting> minesInView(String robot, String camera, Instant time) {
    return world.robot(robot).simulatedCamera(camera).mines(time);
  }

  /** All collisions up to the latest requested time, in order. */
  public List<Collision> collisions() {
    synchronized (world.monitor()) {
      return world.contacts().collisions().stream()
          .map(
              c ->
                  new Collision(
                      world.instant(c.step()),
                      c.robot(),
                      c.other(),
                      c.speed(),
                      c.east(),
                      c.north()))
          .toList();
    }
  }

  /**
   * Number of commands for a time before the latest requested one: if it is not 0, the run is not
   * necessarily bit-reproducible.
   */
  public long lateCommands() {
    return world.lateCommands();
  }
}
