package org.dfra.cli.noise;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.dfra.core.config.RobotXml;
import org.dfra.core.directory.InMemoryModuleDirectory;
import org.dfra.core.module.ModuleImpl;
import org.dfra.core.robot.LocalRobot;
import org.dfra.core.state.StateStore;
import org.dfra.flow.effector.CommandLease;
import org.dfra.flow.effector.DriveCommand.Brake;
import org.dfra.flow.effector.DriveCommand.Velocity;
import org.dfra.flow.effector.DriveEffector;
import org.dfra.flow.sensor.Odometry;
import org.dfra.flow.sensor.OdometrySensor;
import org.dfra.module.Module;
import org.dfra.sim.run.Simulation;
import org.dfra.sim.time.LockStep;
import org.dfra.sim.world.GroundTruth.GroundTruthPose;
import org.dfra.sim.world.description.WorldDescription;
import org.dfra.sim.world.file.WorldXml;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/**
 * The procedure for wheels of {@code docs/reference/sensor-noise.md}, with ten simulated robots: a
 * drive straight on, and turns on the spot.
 */
@Timeout(300)
class WheelNoiseTest {

  private static final Path CONFIG = Path.of(System.getProperty("dfra.root"), "config");
  private static final Duration TURN = Duration.ofMillis(100);
  private static final int ROBOTS = 10;

  /** What was driven: by the odometry, and truly; metres and radians. */
  private record Driven(double counted, double way, double turned, double turn) {}

  @TempDir Path folder;

  /** The robot and its drive, on the field without the post that is in its way. */
  private WorldDescription open() throws Exception {
    String field = Files.readString(CONFIG.resolve("worlds/raster.xml"));
    Path open =
        Files.writeString(folder.resolve("open.xml"), field.replaceAll("<post name=[^>]*/>", ""));
    return NoiseStudyTest.alone(WorldXml.read(open, name -> null), List.of("drive", "battery"));
  }

  /** Drives a new robot for so long, and waits until it has stopped. */
  private Driven drive(long seed, Velocity velocity, Duration time) throws Exception {
    LockStep clock = new LockStep(Instant.parse("2026-11-21T12:00:00Z"));
    try (Simulation world = Simulation.inLockStep(open().withSeed(seed), clock);
        InMemoryModuleDirectory directory = new InMemoryModuleDirectory(clock)) {
      world.start();
      Map<String, String> links = new HashMap<>();
      world.endpoints().forEach(line -> links.put(line.linkVariable(), line.link()));
      try (LocalRobot robot =
          new LocalRobot(
              RobotXml.read(CONFIG.resolve("teams/raster/atrv1.xml"), links::get),
              directory,
              clock,
              path -> StateStore.inMemory())) {
        for (String name : new String[] {"drive", "odometry"}) {
          ModuleImpl module = (ModuleImpl) robot.module(name, Module.class).orElseThrow();
          module.start();
          assertThat(clock.advanceUntil(() -> module.readiness().serves(), time)).isTrue();
        }
        OdometrySensor counter = robot.module("odometry", OdometrySensor.class).orElseThrow();
        Odometry before = counter.odometry();
        GroundTruthPose from = world.world().groundTruth().pose("atrv1", clock.instant());
        double turned = 0;
        double turn = 0;
        double yaw = before.yaw();
        double trueYaw = from.yaw();
        DriveEffector wheels = robot.module("drive", DriveEffector.class).orElseThrow();
        CommandLease lease = wheels.acquireCommandLease(Duration.ofSeconds(30));
        wheels.execute(lease.key(), new Brake(false));
        for (long i = 0; i < time.dividedBy(TURN) + 20; i++) { // two seconds to stop
          wheels.execute(lease.key(), i < time.dividedBy(TURN) ? velocity : new Velocity(0, 0));
          clock.advance(TURN);
          double now = counter.odometry().yaw();
          turned += Math.IEEEremainder(now - yaw, 2 * Math.PI);
          yaw = now;
          double truly = world.world().groundTruth().pose("atrv1", clock.instant()).yaw();
          turn += Math.IEEEremainder(truly - trueYaw, 2 * Math.PI);
          trueYaw = truly;
        }
        lease.close();
        Odometry after = counter.odometry();
        GroundTruthPose to = world.world().groundTruth().pose("atrv1", clock.instant());
        return new Driven(
            Math.hypot(after.x() - before.x(), after.y() - before.y()),
            Math.hypot(to.east() - from.east(), to.north() - from.north()),
            turned,
            turn);
      }
    }
  }

  /**
   * Of ten robots the scales of the encoders differ by 0.005, and the slip of 0.02 changes on the
   * way, so that it counts less; the estimator's default of 0.03 covers both.
   */
  @Test
  void tenDrivesOf20MetresShowTheScaleOfTheWheelsAndTheirSlip() throws Exception {
    SampleSeries parts = new SampleSeries();
    for (long seed = 1; seed <= ROBOTS; seed++) {
      Driven driven = drive(seed, new Velocity(1, 0), Duration.ofSeconds(20));
      assertThat(driven.way()).isBetween(18.0, 22.0);
      parts.add(driven.counted() / driven.way() - 1);
    }
    double scale = parts.deviation();
    double slip = scale * 20 / Math.sqrt(20);
    System.out.printf(
        "way: mean %.4f, wheel_scale_sigma %.4f, wheel_slip %.4f%n", parts.mean(), scale, slip);
    assertThat(scale).isBetween(0.003, 0.03);
    assertThat(slip).isBetween(0.01, 0.14);
  }

  @Test
  void tenTurnsOnTheSpotShowTheScaleAndTheSlipOfTurns() throws Exception {
    SampleSeries parts = new SampleSeries();
    double radians = 0;
    for (long seed = 1; seed <= ROBOTS; seed++) {
      Driven driven = drive(seed, new Velocity(0, 1), Duration.ofSeconds(25));
      assertThat(driven.turned()).isBetween(20.0, 27.0);
      parts.add(driven.turned() / driven.turn() - 1);
      radians += driven.turn() / ROBOTS;
    }
    double scale = parts.deviation();
    double slip = scale * Math.sqrt(radians);
    System.out.printf(
        "turn: mean %.4f, wheel_yaw_scale_sigma %.4f, wheel_yaw_slip %.4f%n",
        parts.mean(), scale, slip);
    assertThat(parts.mean()).isBetween(-0.2, 1.0);
    assertThat(scale).isBetween(0.002, 0.2);
  }
}
