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

  /**
   * A mine visible in a camera's image.
   *
   * @param mine its name
   * @param pixels number that show it
   * @param column of their centre, from the left edge, pixels
   * @param row of their centre, from the upper edge, pixels
   * @param distance of the mine's centre from the camera, metres
   */
  public record MineSighting(String mine, int pixels, double column, double row, double distance) {}

  /**
   * True pose and velocity of a robot, in the world's frame.
   *
   * @param time of the step
   * @param east of its centre, metres
   * @param north of its centre, metres
   * @param up of its base, metres above the ground
   * @param roll radians, left side up is +
   * @param pitch radians, nose down is +
   * @param yaw radians, −π to π, 0 is east, counter-clockwise is +
   * @param eastward velocity, metres per second
   * @param northward velocity, metres per second
   * @param upward velocity, metres per second
   * @param yawRate radians per second, counter-clockwise is +
   */
  public record GroundTruthPose(
      Instant time,
      double east,
      double north,
      double up,
      double roll,
      double pitch,
      double yaw,
      double eastward,
      double northward,
      double upward,
      double yawRate) {

    /** Below this speed a robot counts as stopped, metres per second. */
    private static final double STOPPED_SPEED = 0.01;

    /** Whether the robot is stopped: it moves less than 1 cm in a second. */
    public boolean isStopped() {
      return speed() < STOPPED_SPEED;
    }

    /** Speed over ground, metres per second. */
    public double speed() {
      return Math.sqrt(eastward * eastward + northward * northward);
    }
  }

  /**
   * A collision of a robot.
   *
   * @param time of the step
   * @param robot that moved
   * @param other the obstacle or robot that it hit
   * @param speed relative, at the impact, metres per second
   * @param east position of the robot, metres
   * @param north position of the robot, metres
   */
  public record Collision(
      Instant time, String robot, String other, double speed, double east, double north) {}
}
