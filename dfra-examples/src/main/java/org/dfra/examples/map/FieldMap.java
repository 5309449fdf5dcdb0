package org.dfra.examples.map;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.dfra.geometry.LocalFrame;
import org.dfra.geometry.LocalPosition;
import org.dfra.report.plot.Axis;
import org.dfra.report.plot.PathPanel;
import org.dfra.report.plot.Series;
import org.dfra.sim.world.description.WorldDescription;
import org.dfra.sim.world.description.WorldDescription.MineDescription;
import org.dfra.sim.world.description.WorldDescription.ObstacleDescription;
import org.dfra.sim.world.shape.PlanarShape.Disc;
import org.dfra.sim.world.shape.PlanarShape.Polygon;
import org.dfra.sim.world.shape.PlanarShape.Vertex;

/**
 * A map of a world from above, in a frame that the caller chooses: east to the right, north up,
 * metres.
 */
public final class FieldMap {

  /** The horizontal axis of every map. */
  public static final Axis EAST = Axis.of("east", "m");

  /** The vertical axis of every map. */
  public static final Axis NORTH = Axis.of("north", "m");

  private final WorldDescription described;
  private final LocalFrame world;
  private final LocalFrame frame;

  /**
   * @param world the obstacles and their positions
   * @param frame the frame of the map
   */
  public FieldMap(WorldDescription world, LocalFrame frame) {
    this.described = world;
    this.world = new LocalFrame(world.datum());
    this.frame = frame;
  }

  /**
   * The robots' paths, above the given series and below the obstacles. A ring marks the start, a
   * square the end.
   *
   * @param ground series below everything
   * @param ways of each robot {@code {east, north}}, in the frame of the map
   */
  public PathPanel paths(List<Series> ground, Map<String, double[][]> ways) {
    PathPanel panel = new PathPanel("", EAST, NORTH).add(ground.toArray(Series[]::new));
    ways.forEach((robot, way) -> panel.addPath(Series.line(robot, way[0], way[1])));
    return panel.add(obstacles());
  }

  /** The whole ground of the world, to be drawn first. */
  public Series ground() {
    double east = described.ground().sizeEast();
    double north = described.ground().sizeNorth();
    List<LocalPosition> corners = List.of(at(0, 0), at(east, 0), at(east, north), at(0, north));
    return outline("", corners).faint();
  }

  /** Mines and obstacles, to be drawn last. */
  public Series[] obstacles() {
    List<Series> all = new ArrayList<>();
    for (MineDescription each : described.mines()) {
      LocalPosition at = at(each.east(), each.north());
      all.add(Series.circle("mines", at.east(), at.north(), each.radius()));
    }
    for (ObstacleDescription each : described.obstacles()) {
      if (each.footprint() instanceof Disc disc) {
        LocalPosition at = at(disc.east(), disc.north());
        all.add(Series.circle("obstacles", at.east(), at.north(), disc.radius()));
      } else if (each.footprint() instanceof Polygon polygon) {
        List<LocalPosition> corners = new ArrayList<>();
        for (Vertex corner : polygon.corners()) {
          corners.add(at(corner.east(), corner.north()));
        }
        all.add(outline("obstacles", corners));
      }
    }
    return all.toArray(Series[]::new);
  }

  /** A filled polygon by its corners, in the frame of the map. */
  public static Series outline(String name, List<LocalPosition> corners) {
    return Series.area(
        name,
        corners.stream().mapToDouble(LocalPosition::east).toArray(),
        corners.stream().mapToDouble(LocalPosition::north).toArray());
  }

  private LocalPosition at(double east, double north) {
    return frame.toLocal(world.toGeo(new LocalPosition(east, north, 0)));
  }
}
