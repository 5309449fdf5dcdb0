package org.dfra.sim.world.shape;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.dfra.sim.world.shape.PlanarShape.Disc;
import org.dfra.sim.world.shape.PlanarShape.Polygon;
import org.dfra.sim.world.shape.PlanarShape.Vertex;
import org.junit.jupiter.api.Test;

class RayCasterTest {

  private static final double LONGEST = 30;

  /** A wall 2 m ahead: beams at an angle a meet it at 2/cos a. */
  @Test
  void meetsAWallAhead() {
    RayCaster fan = fan(new MutableTransform(), -1, 0.1, 21);
    fan.intersect(new StaticObstacle("wall", rectangle(2, -50, 3, 50), 1, 0.5));
    for (int i = 0; i < 21; i++) {
      assertThat(fan.distance(i)).isCloseTo(2 / Math.cos(-1 + 0.1 * i), within(1e-12));
      assertThat(fan.reflectivity(i)).isEqualTo(0.5);
    }
  }

  @Test
  void meetsAPostWhereItsSurfaceIs() {
    RayCaster fan = fan(new MutableTransform(), -Math.PI / 2, Math.PI / 2, 3);
    fan.intersect(new StaticObstacle("ahead", new Disc(5, 0, 0.2), 1, 0.5));
    fan.intersect(new StaticObstacle("left", new Disc(0.1, 3, 0.2), 1, 0.5));
    assertThat(fan.distance(0)).isInfinite();
    assertThat(fan.distance(1)).isCloseTo(4.8, within(1e-12));
    assertThat(fan.distance(2)).isCloseTo(3 - Math.sqrt(0.2 * 0.2 - 0.1 * 0.1), within(1e-12));
  }

  @Test
  void seesNeitherBeyondItsRangeNorBelowItsPlane() {
    MutableTransform high = new MutableTransform();
    high.up = 1.1;
    StaticObstacle post = new StaticObstacle("post", new Disc(5, 0, 0.2), 1, 0.5);
    RayCaster above = fan(high, 0, 0.1, 1);
    above.intersect(post);
    assertThat(above.distance(0)).isInfinite();
    RayCaster shortSighted = new RayCaster();
    shortSighted.setBeams(0, 0.1, 1);
    shortSighted.beginScan(new MutableTransform(), 4.7);
    shortSighted.intersect(post);
    assertThat(shortSighted.distance(0)).isInfinite();
  }

  /** Pitched by p from h above the ground, a beam ahead meets it after h/sin p. */
  @Test
  void meetsTheGroundWhenItLooksDown() {
    MutableTransform down = new MutableTransform();
    down.set(0, 0, 0.5, 0, 0.1, 1, 0);
    RayCaster fan = fan(down, -Math.PI / 2, Math.PI / 4, 5);
    assertThat(fan.distance(2)).isCloseTo(0.5 / Math.sin(0.1), within(1e-9));
    assertThat(fan.distance(1))
        .isCloseTo(0.5 / (Math.sin(0.1) * Math.cos(Math.PI / 4)), within(1e-9));
    assertThat(fan.distance(0)).as("level to the side").isInfinite();
  }

  @Test
  void anUpsideDownFanRunsTheOtherWay() {
    MutableTransform upsideDown = new MutableTransform();
    upsideDown.set(0, 0, 0.5, Math.PI, 0, 1, 0);
    RayCaster fan = fan(upsideDown, -Math.PI / 2, Math.PI, 2);
    fan.intersect(new StaticObstacle("left", new Disc(0, 3, 0.5), 1, 0.5));
    assertThat(fan.distance(0)).as("its right is the world's left").isCloseTo(2.5, within(1e-9));
    assertThat(fan.distance(1)).isInfinite();
  }

  /**
   * Random worlds, random fans, also tilted ones and ones that turn to the right or go round more
   * than once; each beam is followed by another method, which knows no bearings: all edges and all
   * discs are cut in the world's frame.
   */
  @Test
  void agreesWithFollowingEachBeam() {
    long seed = Long.getLong("dfra.seed", new Random().nextLong());
    Random random = new Random(seed);
    for (int round = 0; round < 300; round++) {
      agreesOnce(random, "-Ddfra.seed=" + seed + ", round " + round);
    }
  }

  private static void agreesOnce(Random random, String what) {
    MutableTransform pose = randomPose(random);
    List<StaticObstacle> solids = new ArrayList<>();
    for (int i = random.nextInt(40); i > 0; i--) {
      StaticObstacle solid = randomSolid(random);
      if (!solid.outline().contains(pose.east, pose.north)) {
        solids.add(solid);
      }
    }
    OrientedRectangle box =
        new OrientedRectangle(0.5 + random.nextDouble(), 0.5 + random.nextDouble());
    double yaw = random.nextDouble() * 7;
    box.move(20 * random.nextDouble() + 3, 25, Math.cos(yaw), Math.sin(yaw));
    double first = random.nextDouble() * 8 - 4;
    double step = (random.nextDouble() - 0.5) * 0.05;
    int beams = 1 + random.nextInt(400);

    RayCaster fan = fan(pose, first, step, beams);
    solids.forEach(fan::intersect);
    fan.intersect(box, 0, 0.6, 0.5);

    for (int i = 0; i < beams; i++) {
      double c = Math.cos(first + i * step);
      double s = Math.sin(first + i * step);
      BeamByBeam beam = new BeamByBeam(pose, c, s, LONGEST);
      solids.forEach(beam::meet);
      beam.meetBox(box, 0.6);
      assertThat(fan.distance(i))
          .as("%s, beam %d of %d, by %f rad", what, i, beams, step)
          .isCloseTo(beam.distance(), within(1e-6));
    }
  }

  private static MutableTransform randomPose(Random random) {
    MutableTransform pose = new MutableTransform();
    double yaw = random.nextDouble() * 7;
    boolean isLevel = random.nextBoolean();
    double roll = isLevel ? 0 : (random.nextDouble() - 0.5) * 0.6;
    double pitch = isLevel ? 0 : (random.nextDouble() - 0.5) * 0.6;
    boolean isUpsideDown = random.nextInt(4) == 0;
    pose.set(
        20 * random.nextDouble(),
        20 * random.nextDouble(),
        0.1 + 0.8 * random.nextDouble(),
        roll + (isUpsideDown ? Math.PI : 0),
        pitch,
        Math.cos(yaw),
        Math.sin(yaw));
    return pose;
  }

  private static StaticObstacle randomSolid(Random random) {
    double east = 20 * random.nextDouble();
    double north = 20 * random.nextDouble();
    double height = 0.2 + 2 * random.nextDouble();
    double reflectivity = 0.1 + 0.9 * random.nextDouble();
    if (random.nextBoolean()) {
      Disc disc = new Disc(east, north, 0.05 + random.nextDouble());
      return new StaticObstacle("disc", disc, height, reflectivity);
    }
    int corners = 3 + random.nextInt(8);
    List<Vertex> around = new ArrayList<>();
    for (int i = 0; i < corners; i++) { // a star around its middle never crosses itself
      double angle = 2 * Math.PI * (i + 0.8 * random.nextDouble()) / corners;
      double radius = 0.2 + 2 * random.nextDouble();
      around.add(new Vertex(east + radius * Math.cos(angle), north + radius * Math.sin(angle)));
    }
    return new StaticObstacle("star", new Polygon(around), height, reflectivity);
  }

  private static Polygon rectangle(double west, double south, double east, double north) {
    return new Polygon(
        List.of(
            new Vertex(west, south),
            new Vertex(east, south),
            new Vertex(east, north),
            new Vertex(west, north)));
  }

  private static RayCaster fan(MutableTransform pose, double first, double step, int beams) {
    RayCaster fan = new RayCaster();
    fan.setBeams(first, step, beams);
    fan.beginScan(pose, LONGEST);
    return fan;
  }
}
