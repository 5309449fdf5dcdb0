package org.dfra.examples.mission;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.dfra.behaviors.raster.Region;
import org.dfra.geometry.GeoPosition;
import org.dfra.geometry.LocalFrame;
import org.dfra.geometry.LocalPosition;
import org.dfra.sim.world.description.WorldDescription;
import org.dfra.sim.world.file.WorldXml;

/** A search that is over soon: one robot, three lanes or two. */
public final class FewLanes {

  private static final Path ROOT = Path.of(System.getProperty("dfra.root"));

  /** The world in which it is. */
  public static final Path WORLD = ROOT.resolve("config/worlds/raster.xml");

  private static final Path ROBOT = ROOT.resolve("config/teams/raster/atrv1.xml");

  private FewLanes() {}

  /** Between the field's obstacles, metres east and north: three lanes of 7.5 m. */
  public static Scenario scenario() throws Exception {
    return scenario(WORLD, ROBOT);
  }

  /** The same lanes in another world, for a robot that is described elsewhere. */
  public static Scenario scenario(Path file, Path robot) throws Exception {
    return scenario(file, robot, 16.5);
  }

  /** Without the last of these lanes: two, nearly as far from each other. */
  public static Scenario twoLanes(Path file, Path robot) throws Exception {
    return scenario(file, robot, 14.9);
  }

  /**
   * The lanes up to where the region ends.
   *
   * @param east the region's eastern side, metres
   */
  private static Scenario scenario(Path file, Path robot, double east) throws Exception {
    WorldDescription world = WorldXml.read(file, name -> null);
    LocalFrame frame = new LocalFrame(world.datum());
    List<GeoPosition> corners = new ArrayList<>();
    for (double[] corner : new double[][] {{11.5, 2.5}, {east, 2.5}, {east, 10}, {11.5, 10}}) {
      corners.add(frame.toGeo(new LocalPosition(corner[0], corner[1], 0)));
    }
    return new Scenario(world, List.of(robot), Region.of(corners), 2.5, 2);
  }
}
