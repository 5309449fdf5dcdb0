package org.dfra.sim.world;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;
import static org.dfra.sim.world.Worlds.START;
import static org.dfra.sim.world.Worlds.after;
import static org.dfra.sim.world.Worlds.field;
import static org.dfra.sim.world.Worlds.perfectDrive;
import static org.dfra.sim.world.Worlds.ugv;

import java.util.Arrays;
import java.util.List;
import org.dfra.core.config.SourceLocation;
import org.dfra.sim.physics.RangeInput;
import org.dfra.sim.world.description.DeviceDescription;
import org.dfra.sim.world.description.DeviceDescription.MountPose;
import org.dfra.sim.world.description.DeviceKind;
import org.dfra.sim.world.description.VehicleDescription;
import org.dfra.sim.world.description.VehicleDescription.VehicleType;
import org.dfra.sim.world.description.WorldDescription;
import org.dfra.sim.world.description.WorldDescription.GroundDescription;
import org.dfra.sim.world.description.WorldDescription.MineDescription;
import org.dfra.sim.world.description.WorldDescription.ObstacleDescription;
import org.dfra.sim.world.shape.PlanarShape.Disc;
import org.dfra.sim.world.shape.PlanarShape.Polygon;
import org.dfra.sim.world.shape.PlanarShape.Vertex;
import org.junit.jupiter.api.Test;

/** The robot stands at (30, 20) and heads east; its laser is 0.3 m ahead of its middle. */
class LaserTest {

  private static final double DEGREE = Math.PI / 180;

  private static DeviceDescription laser() {
    return new DeviceDescription(DeviceKind.LASER, "laser", MountPose.at(0.3, 0, 0.35))
        .with("white_noise_sigma", 0)
        .with("dropout_probability", 0)
        .with("ghost_rate", 0)
        .with("range_at_10_percent", 1000);
  }

  /** A wall all along a distance ahead, that returns so much light. */
  private static ObstacleDescription wall(double away, double reflectivity) {
    double east = 30.3 + away;
    Polygon outline =
        new Polygon(
            List.of(
                new Vertex(east, -100),
                new Vertex(east + 1, -100),
                new Vertex(east + 1, 140),
                new Vertex(east, 140)));
    return new ObstacleDescription("wall", outline, 2, reflectivity, 0, SourceLocation.CODE);
  }

  private static RangeInput view(WorldDescription world, DeviceDescription laser) {
    return World.of(world.with(ugv("atrv1").with(laser)), START).robot("atrv1").laser("laser");
  }

  private static double[] look(RangeInput view, double seconds, int beams) {
    double[] distances = new double[beams];
    view.measure(after(seconds), -Math.PI / 2, Math.PI / Math.max(1, beams - 1), 80, distances);
    return distances;
  }

  @Test
  void seesFromRightToLeftWhereThingsAre() {
    WorldDescription world =
        field(1)
            .with(new ObstacleDescription("ahead", new Disc(35.3, 20, 0.25), 1))
            .with(new ObstacleDescription("left", new Disc(30.3, 23, 0.25), 1))
            .with(new ObstacleDescription("low", new Disc(30.3, 10, 0.25), 0.3))
            .with(new MineDescription("mine", 32, 20));
    double[] distances = look(view(world, laser()), 0, 181);
    assertThat(distances[90]).isCloseTo(4.75, within(1e-9));
    assertThat(distances[180]).isCloseTo(2.75, within(1e-9));
    assertThat(distances[0]).as("lower than the laser").isInfinite();
    assertThat(distances[45]).isInfinite();
  }

  @Test
  void seesOtherRobotsAsRectanglesAndNotItself() {
    WorldDescription world =
        field(1).with(new VehicleDescription("two", VehicleType.UGV, 36, 20, Math.PI / 2));
    double[] distances = look(view(world, laser()), 0, 181);
    assertThat(distances[90])
        .as("its side, 0.32 m before its middle")
        .isCloseTo(5.38, within(1e-9));
    double corner = Math.toDegrees(Math.atan2(0.39, 5.38)); // its half length
    assertThat(distances[90 + (int) corner]).isFinite();
    assertThat(distances[90 + (int) corner + 1]).isInfinite();
    assertThat(distances[0]).isInfinite();
  }

  @Test
  void looksFromWhereItIsMountedAsItsRobotMoves() {
    World world =
        World.of(
            field(1).with(wall(20, 0.5)).with(ugv("atrv1").with(perfectDrive()).with(laser())),
            START);
    world.robot("atrv1").drivetrain("drive").drive(START, 1, 0, 1e9, 1e9);
    RangeInput view = world.robot("atrv1").laser("laser");
    double[] distances = new double[1];
    view.measure(after(5.015), 0, DEGREE, 80, distances);
    assertThat(distances[0]).isCloseTo(20 - 4.995, within(1e-9));
    view.measure(after(5.015), Math.PI / 3, DEGREE, 80, distances);
    assertThat(distances[0]).isCloseTo(2 * (20 - 4.995), within(1e-6));
  }

  /** Of 361 × 100 ranges the mean is known to σ/190 and σ to σ/269; four times that is allowed. */
  @Test
  void rangesAreNormallySpreadAroundTheTruth() {
    WorldDescription world =
        field(1).with(new ObstacleDescription("ring", ring(30.3, 20, 5, 6), 2));
    RangeInput view = view(world, laser().with("white_noise_sigma", 0.02));
    RangeInput exact = view(world, laser());
    double[] errors = new double[361 * 100];
    for (int scan = 0; scan < 100; scan++) {
      double[] noisy = look(view, scan * 0.1, 361);
      double[] true0 = look(exact, scan * 0.1, 361);
      for (int i = 0; i < 361; i++) {
        errors[scan * 361 + i] = noisy[i] - true0[i];
      }
    }
    assertThat(Statistics.mean(errors)).isCloseTo(0, within(0.02 / 190 * 4));
    assertThat(Statistics.sigma(errors)).isCloseTo(0.02, within(0.02 / 269 * 4));
    assertThat(Statistics.correlation(errors, 1)).isCloseTo(0, within(4 / 190.0));
    assertThat(Statistics.correlation(errors, 361)).isCloseTo(0, within(4 / 190.0));
  }

  /** A ring open to the east, around a place: many-sided, so that every beam meets it. */
  private static Polygon ring(double east, double north, double inner, double outer) {
    Vertex[] corners = new Vertex[2 * 180];
    for (int i = 0; i < 180; i++) {
      double angle = -Math.PI * 0.6 + i * Math.PI * 1.2 / 179;
      double c = Math.cos(angle);
      double s = Math.sin(angle);
      corners[i] = new Vertex(east + outer * c, north + outer * s);
      corners[359 - i] = new Vertex(east + inner * c, north + inner * s);
    }
    return new Polygon(List.of(corners));
  }

  /** Of 36 100 beams a tenth is known to 0.0016; four times that is allowed. */
  @Test
  void missesAsManyBeamsAsItShould() {
    RangeInput view = view(field(1).with(wall(3, 0.5)), laser().with("dropout_probability", 0.1));
    int missed = 0;
    for (int scan = 0; scan < 100; scan++) {
      double[] distances = new double[361];
      view.measure(after(scan * 0.1), -1, 2.0 / 360, 80, distances);
      missed += (int) Arrays.stream(distances).filter(Double::isInfinite).count();
    }
    assertThat(missed / 36_100.0).isCloseTo(0.1, within(0.0064));
  }

  /** With 10 m at a tenth, it sees what returns 0.4 twice as far: 20 m, half of it just there. */
  @Test
  void seesDarkThingsLessFar() {
    DeviceDescription laser = laser().with("range_at_10_percent", 10);
    assertThat(seen(view(field(1).with(wall(15.9, 0.4)), laser))).isEqualTo(1);
    assertThat(seen(view(field(1).with(wall(20, 0.4)), laser))).isCloseTo(0.5, within(0.07));
    assertThat(seen(view(field(1).with(wall(24.1, 0.4)), laser))).isZero();
    assertThat(seen(view(field(1).with(wall(8.1, 0.1)), laser))).isBetween(0.5, 0.999);
  }

  /** The part of 1000 beams straight ahead that come back; a half is known to 0.016 of it. */
  private static double seen(RangeInput view) {
    int seen = 0;
    for (int scan = 0; scan < 1000; scan++) {
      double[] distances = new double[1];
      view.measure(after(scan * 0.01), 0, DEGREE, 80, distances);
      seen += Double.isFinite(distances[0]) ? 1 : 0;
    }
    return seen / 1000.0;
  }

  /**
   * Two ghosts a second, each for 0.15 s on average, are 0.3 at a time; over 1000 s that is known
   * from 2000 ghosts to 2.2 % or so. Each covers about 0.1 rad of 181 beams a degree apart: 5.7
   * beams. Four times is allowed, and ghosts that overlap.
   */
  @Test
  void ghostsAreShortNarrowAndRare() {
    RangeInput view =
        view(
            field(1),
            laser().with("ghost_rate", 2).with("ghost_width", 0.1).with("ghost_max_range", 4));
    int haunted = 0;
    int scansHaunted = 0;
    double nearest = 80;
    double farthest = 0;
    for (int scan = 0; scan < 10_000; scan++) {
      double[] distances = look(view, scan * 0.1, 181);
      double[] ghosts = Arrays.stream(distances).filter(Double::isFinite).toArray();
      haunted += ghosts.length;
      scansHaunted += ghosts.length > 0 ? 1 : 0;
      for (double ghost : ghosts) {
        nearest = Math.min(nearest, ghost);
        farthest = Math.max(farthest, ghost);
      }
    }
    assertThat(haunted / 10_000.0).isCloseTo(0.3 * 5.73, within(0.12 * 0.3 * 5.73));
    assertThat(scansHaunted / 10_000.0).isCloseTo(1 - Math.exp(-0.3), within(0.03));
    assertThat(nearest).isBetween(0.6, 0.8);
    assertThat(farthest).isBetween(3.8, 4.0);
  }

  /**
   * A ghost lasts for 0.15 s on average, so few are in five scans of 10 Hz, as a filter counts on.
   */
  @Test
  void aGhostIsGoneAfterAFewScans() {
    RangeInput view = view(field(1), laser().with("ghost_rate", 0.5));
    int longest = 0;
    int[] runs = new int[181];
    for (int scan = 0; scan < 3000; scan++) {
      double[] distances = look(view, scan * 0.1, 181);
      for (int i = 0; i < 181; i++) {
        runs[i] = Double.isFinite(distances[i]) ? runs[i] + 1 : 0;
        longest = Math.max(longest, runs[i]);
      }
    }
    assertThat(longest).isBetween(2, 4);
  }

  @Test
  void roughGroundTiltsItsBeamsIntoTheGround() {
    WorldDescription rough =
        field(1).withGround(new GroundDescription(60, 40, 0.15, SourceLocation.CODE));
    double[] distances = look(view(rough, laser()), 0, 181);
    double lowest = Arrays.stream(distances).min().orElseThrow();
    assertThat(lowest).as("0.35 m over a slope of some 0.1 rad").isBetween(1.0, 40.0);
    assertThat(Arrays.stream(look(view(field(1), laser()), 0, 181)).min().orElseThrow())
        .isInfinite();
  }

  @Test
  void refusesWhatIsNoLook() {
    RangeInput view = view(field(1), laser());
    assertThatThrownBy(() -> view.measure(START, 0, 0.1, -1, new double[1]))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageContaining("-1.0 m");
    assertThatThrownBy(() -> view.measure(START, 0, 0, 1, new double[1]))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageContaining("by 0.0 rad");
    assertThatThrownBy(
            () -> World.of(field(1).with(ugv("atrv1").with(laser())), START).robot("atrv"))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageContaining("did you mean \"atrv1\"?");
    assertThatThrownBy(
            () ->
                World.of(field(1).with(ugv("atrv1").with(laser())), START)
                    .robot("atrv1")
                    .drivetrain("laser"))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessage("atrv1 has no drive \"laser\"; it has none");
  }
}
