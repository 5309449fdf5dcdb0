package org.dfra.sim.world.render;

import java.util.ArrayList;
import java.util.List;
import org.dfra.sim.world.description.WorldDescription;
import org.dfra.sim.world.description.WorldDescription.MineDescription;
import org.dfra.sim.world.description.WorldDescription.ObstacleDescription;
import org.dfra.sim.world.noise.RandomStream;
import org.dfra.sim.world.render.MeshFace.Paint;
import org.dfra.sim.world.shape.PlanarShape.Disc;

/**
 * The meshes of a world's static objects. Created once for a world and shared by its cameras;
 * immutable.
 */
public final class Scenery {

  private static final int POST_SIDES = 12;
  private static final int MINE_SIDES = 16;
  private static final double PLATE_RADIUS = 0.55; // of a mine's radius
  private static final double PLATE_HEIGHT = 1.2; // of a mine's height
  private static final double PLATE_BRIGHTNESS = 0.8; // of its colour

  /** The facets of one object, with a bounding ball. */
  record Group(List<MeshFace> facets, double east, double north, double up, double radius) {}

  final Light light;
  final GroundTexture meadow;
  final List<Group> groups;

  /**
   * @param draws random numbers for the pattern of the ground
   */
  public Scenery(WorldDescription world, RandomStream draws) {
    light = new Light(world.weather());
    meadow = new GroundTexture(draws, light);
    List<Group> all = new ArrayList<>();
    world.obstacles().forEach(obstacle -> all.add(group(obstacle)));
    for (int i = 0; i < world.mines().size(); i++) {
      all.add(group(world.mines().get(i), i + 1));
    }
    groups = List.copyOf(all);
  }

  private static Group group(ObstacleDescription obstacle) {
    boolean isPost = obstacle.footprint() instanceof Disc;
    Paint paint = new Paint(obstacle.colour(), 0, isPost ? 0.5 : 0.25, !isPost, 0);
    Disc bounds = obstacle.footprint().bounds();
    double half = obstacle.height() / 2;
    return new Group(
        MeshBuilder.prism(obstacle.footprint(), POST_SIDES, 0, obstacle.height(), paint),
        bounds.east(),
        bounds.north(),
        half,
        Math.sqrt(bounds.radius() * bounds.radius() + half * half));
  }

  private Group group(MineDescription mine, int label) {
    double warmth =
        meadow.temperature(mine.east(), mine.north()) - light.air + mine.thermalContrast();
    Paint body = Paint.heated(mine.colour(), warmth, label);
    Paint plate = Paint.heated(Light.lit(mine.colour(), PLATE_BRIGHTNESS), warmth, label);
    Disc outline = new Disc(mine.east(), mine.north(), mine.radius());
    Disc inner = new Disc(mine.east(), mine.north(), PLATE_RADIUS * mine.radius());
    double bodyTop = mine.height() / PLATE_HEIGHT;
    List<MeshFace> facets =
        new ArrayList<>(MeshBuilder.prism(outline, MINE_SIDES, 0, bodyTop, body));
    facets.addAll(MeshBuilder.prism(inner, MINE_SIDES, bodyTop, mine.height(), plate));
    return new Group(
        List.copyOf(facets),
        mine.east(),
        mine.north(),
        mine.height() / 2,
        Math.sqrt(mine.radius() * mine.radius() + mine.height() * mine.height() / 4));
  }
}
