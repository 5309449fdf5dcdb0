package org.dfra.benchmarks;

import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.dfra.geometry.GeoPosition;
import org.dfra.sim.physics.CameraInput;
import org.dfra.sim.physics.DrivetrainPhysics;
import org.dfra.sim.physics.RangeInput;
import org.dfra.sim.world.SimulatedRobot;
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
import org.dfra.sim.world.shape.PlanarShape.Polygon;
import org.dfra.sim.world.shape.PlanarShape.Vertex;

/**
 * Measures the speed of a simulated world: robots drive among posts, hedges and each other, each
 * scans with its laser, and cameras take images. All values are CPU time of one thread, per second
 * of simulated time; the first half warms up.
 */
final class WorldBench implements Bench {

  private static final ThreadMXBean THREADS = ManagementFactory.getThreadMXBean();
  private static final Instant BEGIN = Instant.parse("2026-04-01T10:00:00Z");
  private static final long SEED = 1;
  private static final double SIZE = 120; // metres
  private static final double BETWEEN = SIZE / 10; // robots, metres
  private static final int ROBOTS = 100;
  private static final int POSTS = 100;
  private static final int HEDGES = 20;
  private static final int MINES = 50;
  private static final int SCANS = 10; // in a second
  private static final int BEAMS = 361;
  private static final double RANGE = 80; // metres
  private static final int SECONDS = 30;
  private static final int PICTURES = 200;
  private static final double MOST_FOR_A_SECOND = 0.1; // seconds: ten times as fast as the world
  private static final double MOST_FOR_A_PICTURE = 5; // milliseconds

  @Override
  public void run(Report report) {
    World world = World.of(description(), BEGIN);
    report.say(
        ROBOTS
            + " robots among "
            + POSTS
            + " posts and "
            + HEDGES
            + " hedges, "
            + BEAMS
            + " beams of "
            + Math.round(RANGE)
            + " m at "
            + SCANS
            + " Hz each; one thread.");
    Instant end = scans(report, world);
    report.say(world.groundTruth().collisions().size() + " collisions.");
    SimulatedRobot robot = world.robot("robot_50");
    pictures(report, "a picture of 320 × 240 in light", robot.camera("camera"), end);
    pictures(report, "a picture of 320 × 240 in heat", robot.camera("thermal"), end);
  }

  private static Instant scans(Report report, World world) {
    List<RangeInput> lasers = new ArrayList<>();
    List<DrivetrainPhysics> drives = new ArrayList<>();
    for (SimulatedRobot robot : world.robots()) {
      lasers.add(robot.laser("laser"));
      drives.add(robot.drivetrain("drive"));
    }
    double[] distances = new double[BEAMS];
    double[] seconds = new double[SECONDS];
    Random random = new Random(SEED);
    Instant time = BEGIN;
    for (int second = 0; second < 2 * SECONDS; second++) {
      long began = THREADS.getCurrentThreadCpuTime();
      for (DrivetrainPhysics drive : drives) {
        drive.drive(time, random.nextDouble(), random.nextDouble() - 0.5, 1, 2);
      }
      for (int scan = 0; scan < SCANS; scan++) {
        for (RangeInput laser : lasers) {
          laser.measure(time, -Math.PI / 2, Math.PI / (BEAMS - 1), RANGE, distances);
        }
        time = time.plusMillis(1000 / SCANS);
      }
      world.advanceTo(time);
      seconds[second % SECONDS] = (THREADS.getCurrentThreadCpuTime() - began) / 1e9;
    }
    double median = Report.quantile(seconds, 0.5);
    report.figure(
        "processor time for a second of " + ROBOTS + " robots", median, MOST_FOR_A_SECOND, "s");
    report.figure("faster than real time, on one core", 1 / median, "×");
    report.figure(
        "processor time for a beam, all else included",
        median * 1e9 / (ROBOTS * SCANS * BEAMS),
        "ns");
    return time;
  }

  private static void pictures(Report report, String what, CameraInput camera, Instant time) {
    double[] millis = new double[PICTURES];
    for (int i = 0; i < 2 * PICTURES; i++) {
      long began = THREADS.getCurrentThreadCpuTime();
      CameraInput.Frame unused = camera.capture(time);
      millis[i % PICTURES] = (THREADS.getCurrentThreadCpuTime() - began) / 1e6;
    }
    double median = Report.quantile(millis, 0.5);
    report.figure("processor time for " + what, median, MOST_FOR_A_PICTURE, "ms");
  }

  private static WorldDescription description() {
    Random random = new Random(SEED);
    GeoPosition datum = new GeoPosition(48, 11, 520);
    WorldDescription world = new WorldDescription("bench", SEED, datum, SIZE, SIZE);
    for (int i = 0; i < ROBOTS; i++) {
      double yaw = 2 * Math.PI * random.nextDouble();
      double east = BETWEEN * (i % 10 + 0.5);
      double north = BETWEEN * (i / 10 + 0.5);
      world =
          world.with(
              robot(new VehicleDescription("robot_" + i, VehicleType.UGV, east, north, yaw)));
    }
    for (int i = 0; i < POSTS; i++) { // between the rows of robots
      double east = SIZE * random.nextDouble();
      double north = BETWEEN * (random.nextInt(10) + 0.8 + 0.3 * random.nextDouble());
      Disc outline = new Disc(east, north, 0.05 + 0.1 * random.nextDouble());
      world = world.with(new ObstacleDescription("post_" + i, outline, 1.5));
    }
    for (int i = 0; i < HEDGES; i++) {
      world = world.with(hedge(i));
    }
    for (int i = 0; i < MINES; i++) {
      double east = SIZE * random.nextDouble();
      double north = SIZE * random.nextDouble();
      world = world.with(new MineDescription("mine_" + i, east, north));
    }
    return world;
  }

  private static ObstacleDescription hedge(int number) {
    double west = BETWEEN * (number % 10) + 1;
    double south = BETWEEN * (number / 10 * 4 + 2) - 0.6;
    List<Vertex> corners =
        List.of(
            new Vertex(west, south),
            new Vertex(west + 5, south + 0.2),
            new Vertex(west + 8, south + 0.8),
            new Vertex(west + 5, south + 1),
            new Vertex(west, south + 0.9));
    return new ObstacleDescription("hedge_" + number, new Polygon(corners), 1.2);
  }

  private static VehicleDescription robot(VehicleDescription bare) {
    return bare.with(device(DeviceKind.DRIVE, "drive", MountPose.MIDDLE))
        .with(device(DeviceKind.LASER, "laser", MountPose.at(0.3, 0, 0.35)))
        .with(device(DeviceKind.BATTERY, "battery", MountPose.MIDDLE))
        .with(device(DeviceKind.CAMERA, "camera", MountPose.at(0.2, 0, 0.7)))
        .with(device(DeviceKind.THERMAL, "thermal", MountPose.at(0.2, 0, 0.7)));
  }

  private static DeviceDescription device(DeviceKind kind, String name, MountPose mount) {
    return new DeviceDescription(kind, name, mount);
  }
}
