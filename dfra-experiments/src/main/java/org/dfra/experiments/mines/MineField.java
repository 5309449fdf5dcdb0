package org.dfra.experiments.mines;

import java.util.List;
import java.util.Random;
import org.dfra.core.config.SourceLocation;
import org.dfra.geometry.GeoPosition;
import org.dfra.sim.world.description.DeviceDescription;
import org.dfra.sim.world.description.DeviceDescription.MountPose;
import org.dfra.sim.world.description.DeviceKind;
import org.dfra.sim.world.description.VehicleDescription;
import org.dfra.sim.world.description.VehicleDescription.VehicleType;
import org.dfra.sim.world.description.WorldDescription;
import org.dfra.sim.world.description.WorldDescription.MineDescription;
import org.dfra.sim.world.description.WorldDescription.ObstacleDescription;
import org.dfra.sim.world.description.WorldDescription.WeatherDescription;
import org.dfra.sim.world.shape.PlanarShape.Disc;
import org.dfra.sim.world.shape.PlanarShape.Polygon;
import org.dfra.sim.world.shape.PlanarShape.Vertex;

/**
 * Fields with a lane along their middle, mines on both sides of it, and objects that resemble
 * mines: stones, posts, a hedge on each side, and the shadows of all of them, with another sun
 * position each time. The same seed gives the same field.
 */
final class MineField {

  static final String ROBOT = "robot";
  static final String CAMERA = "camera";
  static final String THERMAL = "thermal";

  /** Of both cameras, which are tilted 29° down over the robot's bow. */
  static final MountPose MOUNT = new MountPose(0.35, 0, 0.7, 0, 0.5, 0);

  /** Of both cameras, radians. */
  static final double FIELD_OF_VIEW = 1.05;

  private static final GeoPosition DATUM = new GeoPosition(48, 11, 520);
  private static final double LENGTH = 24; // metres
  private static final double MIDDLE = 6; // metres north
  private static final double START = 2; // metres east
  private static final int MINES = 8;
  private static final int STONES = 5;
  private static final int POSTS = 5;
  private static final double FREE = 0.9; // metres beside the lane's middle, for the robot

  private final Random random;

  private MineField(long seed) {
    this.random = new Random(seed);
  }

  static WorldDescription of(long seed) {
    MineField field = new MineField(seed);
    WorldDescription world =
        new WorldDescription("mines", seed, DATUM, LENGTH, 2 * MIDDLE).withWeather(field.weather());
    for (int i = 0; i < MINES; i++) {
      world = world.with(field.mine(i));
    }
    for (int i = 0; i < STONES; i++) {
      world =
          world.with(
              field.standing("stone_" + i, field.between(0.08, 0.2), field.between(0.08, 0.25)));
    }
    for (int i = 0; i < POSTS; i++) {
      world = world.with(field.standing("post_" + i, field.between(0.05, 0.12), 1.5));
    }
    return world
        .with(field.hedge("hedge_north", 1))
        .with(field.hedge("hedge_south", -1))
        .with(
            new VehicleDescription(ROBOT, VehicleType.UGV, START, MIDDLE, 0)
                .with(new DeviceDescription(DeviceKind.DRIVE, "drive", MountPose.MIDDLE))
                .with(camera(DeviceKind.CAMERA, CAMERA))
                .with(camera(DeviceKind.THERMAL, THERMAL)));
  }

  private static DeviceDescription camera(DeviceKind kind, String name) {
    return new DeviceDescription(kind, name, MOUNT).with("field_of_view", FIELD_OF_VIEW);
  }

  private double between(double low, double high) {
    return low + (high - low) * random.nextDouble();
  }

  private double side() {
    return random.nextBoolean() ? 1 : -1;
  }

  private WeatherDescription weather() {
    return new WeatherDescription(
        between(280, 305),
        between(3, 15),
        between(-Math.PI, Math.PI),
        between(0.3, 1.2),
        2,
        0,
        0.8,
        SourceLocation.CODE);
  }

  /** 1 K to 5 K warmer or colder than the ground, with slight variations of colour. */
  private MineDescription mine(int number) {
    int colour = 0;
    for (int shift = 16; shift >= 0; shift -= 8) {
      int level = (MineDescription.COLOUR >> shift & 0xFF) + random.nextInt(11) - 5;
      colour |= level << shift;
    }
    return new MineDescription(
        "mine_" + number,
        START + 3 + (LENGTH - START - 6) * (number + random.nextDouble()) / MINES,
        MIDDLE + between(-1.4, 1.4),
        MineDescription.RADIUS,
        MineDescription.HEIGHT,
        side() * between(1, 5),
        colour,
        SourceLocation.CODE);
  }

  private ObstacleDescription standing(String name, double radius, double height) {
    double east = between(START + 2, LENGTH - 1);
    double north = MIDDLE + side() * between(FREE, 2.2);
    return new ObstacleDescription(name, new Disc(east, north, radius), height);
  }

  private ObstacleDescription hedge(String name, double side) {
    double east = between(START + 2, LENGTH - 8);
    double near = MIDDLE + side * between(1.6, 2.6);
    double far = near + side * 0.6;
    List<Vertex> corners =
        List.of(
            new Vertex(east, Math.min(near, far)),
            new Vertex(east + 6, Math.min(near, far) + 0.1),
            new Vertex(east + 6, Math.max(near, far)),
            new Vertex(east, Math.max(near, far)));
    return new ObstacleDescription(name, new Polygon(corners), 1.2);
  }
}
