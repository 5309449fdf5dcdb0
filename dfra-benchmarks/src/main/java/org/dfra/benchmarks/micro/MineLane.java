package org.dfra.benchmarks.micro;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import org.dfra.behaviors.perceptual.mines.MineObservation.GroundPoint;
import org.dfra.flow.sensor.CameraImage;
import org.dfra.flow.sensor.CameraImage.Band;
import org.dfra.geometry.GeoPosition;
import org.dfra.geometry.Transform;
import org.dfra.sim.device.camera.FrameEncoder;
import org.dfra.sim.physics.CameraInput;
import org.dfra.sim.world.GroundTruth.GroundTruthPose;
import org.dfra.sim.world.World;
import org.dfra.sim.world.description.DeviceDescription;
import org.dfra.sim.world.description.DeviceDescription.MountPose;
import org.dfra.sim.world.description.DeviceKind;
import org.dfra.sim.world.description.VehicleDescription;
import org.dfra.sim.world.description.VehicleDescription.VehicleType;
import org.dfra.sim.world.description.WorldDescription;
import org.dfra.sim.world.description.WorldDescription.MineDescription;
import org.dfra.sim.world.description.WorldDescription.ObstacleDescription;
import org.dfra.sim.world.shape.PlanarShape.Disc;

/**
 * The images of a simulated robot that drives along a lane with mines, stones and posts, encoded as
 * its cameras send them: 320 × 240, JPEG in light and PNG in heat. Always the same.
 */
final class MineLane {

  private static final Instant BEGIN = Instant.parse("2026-11-21T12:00:00Z");
  private static final Duration STEP = Duration.ofSeconds(1);
  private static final int LOOKS = 8;
  private static final String ROBOT = "robot";

  /** Of both cameras, tilted 29° down over the robot's bow; as in {@code ./dfra bench mines}. */
  private static final MountPose MOUNT = new MountPose(0.35, 0, 0.7, 0, 0.5, 0);

  private static final double FIELD_OF_VIEW = 1.05; // radians
  private static final double LENGTH = 16; // metres
  private static final double MIDDLE = 6; // metres north
  private static final double START = 2; // metres east

  /** Metres east and north of the start. */
  private static final double[][] MINES = {
    {2.4, 0.4}, {3.7, -0.5}, {5.2, 0.1}, {6.8, 0.7}, {8.1, -0.3}, {9.6, 0.5}
  };

  private MineLane() {}

  /**
   * An image.
   *
   * @param image as the camera sends it
   * @param mines true positions of all mines, in the frame of the robot's base, seen or not
   */
  record LabelledImage(CameraImage image, List<GroundPoint> mines) {

    LabelledImage {
      mines = List.copyOf(mines);
    }
  }

  /** Pose of both cameras on the robot's base. */
  static Transform mount() {
    return Transform.of(MOUNT.x(), MOUNT.y(), MOUNT.z(), MOUNT.roll(), MOUNT.pitch(), MOUNT.yaw());
  }

  /** The images of one camera, a metre apart. */
  static List<LabelledImage> images(Band band) {
    String name = band == Band.THERMAL ? "thermal" : "camera";
    World world = World.of(description(), BEGIN);
    CameraInput camera = world.robot(ROBOT).camera(name);
    FrameEncoder encoder = new FrameEncoder(band);
    List<LabelledImage> images = new ArrayList<>();
    Instant time = BEGIN;
    for (int i = 0; i < LOOKS; i++) {
      world.robot(ROBOT).drivetrain("drive").drive(time, 1, 0, 2, 2);
      time = time.plus(STEP);
      world.advanceTo(time);
      CameraInput.Frame frame = camera.capture(time);
      CameraImage image =
          new CameraImage(
              time,
              ROBOT + "/" + name,
              band,
              frame.width(),
              frame.height(),
              frame.width() / 2.0 / Math.tan(FIELD_OF_VIEW / 2),
              encoder.mediaType(),
              encoder.encode(frame));
      images.add(new LabelledImage(image, mines(world.groundTruth().pose(ROBOT, time))));
    }
    return images;
  }

  private static List<GroundPoint> mines(GroundTruthPose robot) {
    List<GroundPoint> mines = new ArrayList<>();
    for (double[] each : MINES) {
      double east = START + each[0] - robot.east();
      double north = MIDDLE + each[1] - robot.north();
      double cos = Math.cos(robot.yaw());
      double sin = Math.sin(robot.yaw());
      mines.add(new GroundPoint(cos * east + sin * north, cos * north - sin * east));
    }
    return mines;
  }

  private static WorldDescription description() {
    WorldDescription world =
        new WorldDescription("lane", 1, new GeoPosition(48, 11, 520), LENGTH, 2 * MIDDLE);
    for (int i = 0; i < MINES.length; i++) {
      world =
          world.with(new MineDescription("mine_" + i, START + MINES[i][0], MIDDLE + MINES[i][1]));
      double east = START + MINES[i][0] + 0.6;
      world = world.with(disc("stone_" + i, east, MIDDLE - 1.2 * MINES[i][1] - 0.9, 0.12, 0.15));
      world = world.with(disc("post_" + i, east + 0.5, MIDDLE + 1.6, 0.08, 1.5));
    }
    return world.with(
        new VehicleDescription(ROBOT, VehicleType.UGV, START, MIDDLE, 0)
            .with(new DeviceDescription(DeviceKind.DRIVE, "drive", MountPose.MIDDLE))
            .with(camera(DeviceKind.CAMERA, "camera"))
            .with(camera(DeviceKind.THERMAL, "thermal")));
  }

  private static ObstacleDescription disc(
      String name, double east, double north, double radius, double height) {
    return new ObstacleDescription(name, new Disc(east, north, radius), height);
  }

  private static DeviceDescription camera(DeviceKind kind, String name) {
    return new DeviceDescription(kind, name, MOUNT).with("field_of_view", FIELD_OF_VIEW);
  }
}
