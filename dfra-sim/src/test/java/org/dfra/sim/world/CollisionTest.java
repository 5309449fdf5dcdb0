package org.dfra.sim.world;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.dfra.sim.world.Worlds.START;
import static org.dfra.sim.world.Worlds.after;
import static org.dfra.sim.world.Worlds.field;
import static org.dfra.sim.world.Worlds.perfectDrive;
import static org.dfra.sim.world.Worlds.ugv;

import java.util.List;
import org.dfra.sim.world.GroundTruth.Collision;
import org.dfra.sim.world.GroundTruth.GroundTruthPose;
import org.dfra.sim.world.description.VehicleDescription;
import org.dfra.sim.world.description.VehicleDescription.VehicleType;
import org.dfra.sim.world.description.WorldDescription;
import org.dfra.sim.world.description.WorldDescription.ObstacleDescription;
import org.dfra.sim.world.shape.PlanarShape.Disc;
import org.dfra.sim.world.shape.PlanarShape.Polygon;
import org.dfra.sim.world.shape.PlanarShape.Vertex;
import org.junit.jupiter.api.Test;

class CollisionTest {

  private static final double AT_ONCE = 1e9;

  /** A wall whose face is at 33 m, 2.61 m ahead of the robot's bumper. */
  private static final ObstacleDescription WALL =
      new ObstacleDescription(
          "wall",
          new Polygon(
              List.of(
                  new Vertex(33, 10), new Vertex(34, 10), new Vertex(34, 30), new Vertex(33, 30))),
          2);

  private static void drive(World world, String robot, double seconds, double speed) {
    world.robot(robot).drivetrain("drive").drive(after(seconds), speed, 0, AT_ONCE, AT_ONCE);
  }

  @Test
  void stopsAtAWallAndReportsItOnce() {
    World world = World.of(field(1).with(WALL).with(ugv("atrv1").with(perfectDrive())), START);
    drive(world, "atrv1", 0, 1);
    GroundTruthPose pose = world.groundTruth().pose("atrv1", after(10));
    assertThat(pose.east()).as("a step before the wall").isBetween(32.6, 32.61);
    assertThat(pose.speed()).isZero();
    assertThat(world.robot("atrv1").drivetrain("drive").travel(after(10)).speed())
        .as("its wheels spin on")
        .isEqualTo(1);
    assertThat(world.groundTruth().collisions())
        .singleElement()
        .satisfies(
            collision -> {
              assertThat(collision.robot()).isEqualTo("atrv1");
              assertThat(collision.other()).isEqualTo("wall");
              assertThat(collision.speed()).isCloseTo(1, within(1e-9));
              assertThat(collision.time()).isBetween(after(2.61), after(2.64));
            });
  }

  @Test
  void getsAwayAndMayCollideAgain() {
    World world = World.of(field(1).with(WALL).with(ugv("atrv1").with(perfectDrive())), START);
    drive(world, "atrv1", 0, 1);
    drive(world, "atrv1", 5, -1);
    assertThat(world.groundTruth().pose("atrv1", after(7)).east()).isCloseTo(30.61, within(0.03));
    drive(world, "atrv1", 7, 0.5);
    world.advanceTo(after(15));
    assertThat(world.groundTruth().collisions()).hasSize(2);
    assertThat(world.groundTruth().collisions().get(1).speed()).isCloseTo(0.5, within(1e-9));
  }

  /** Two that meet at 1 m/s each meet at 2 m/s, and that is one collision. */
  @Test
  void twoRobotsStopAtEachOther() {
    WorldDescription description =
        field(1)
            .with(new VehicleDescription("one", VehicleType.UGV, 10, 20, 0).with(perfectDrive()))
            .with(
                new VehicleDescription("two", VehicleType.UGV, 20, 20, Math.PI)
                    .with(perfectDrive()));
    World world = World.of(description, START);
    drive(world, "one", 0, 1);
    drive(world, "two", 0, 1);
    world.advanceTo(after(10));
    double gap =
        world.groundTruth().pose("two", after(10)).east()
            - world.groundTruth().pose("one", after(10)).east();
    assertThat(gap).isBetween(0.78, 0.81);
    assertThat(world.groundTruth().collisions())
        .singleElement()
        .satisfies(c -> assertThat(c.speed()).isCloseTo(2, within(1e-6)));
  }

  /**
   * Its half diagonal is 0.504 m and lies 0.687 rad off its heading, so at yaw it reaches 0.504
   * cos(yaw − 0.687) m to the east. 0.48 m before a wall it gets stuck at a yaw of 0.687 + 0.311
   * rad.
   */
  @Test
  void aCornerThatTouchesKeepsItFromTurning() {
    VehicleDescription robot = new VehicleDescription("atrv1", VehicleType.UGV, 32.52, 20, 1.2);
    World world = World.of(field(1).with(WALL).with(robot.with(perfectDrive())), START);
    world.robot("atrv1").drivetrain("drive").drive(START, 0, -0.5, AT_ONCE, AT_ONCE);
    assertThat(world.groundTruth().pose("atrv1", after(5)).yaw()).isBetween(0.99, 1.01);
    assertThat(world.groundTruth().collisions()).hasSize(1);
  }

  @Test
  void stopsAtAPost() {
    ObstacleDescription post = new ObstacleDescription("post", new Disc(32, 20.2, 0.1), 1);
    World world = World.of(field(1).with(post).with(ugv("atrv1").with(perfectDrive())), START);
    drive(world, "atrv1", 0, 0.7);
    assertThat(world.groundTruth().pose("atrv1", after(6)).east()).isBetween(31.5, 31.51);
    assertThat(world.groundTruth().collisions())
        .extracting(Collision::other)
        .containsExactly("post");
  }
}
