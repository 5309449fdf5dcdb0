package org.dfra.examples.mission;

import java.nio.file.Path;
import java.util.List;
import org.dfra.behaviors.raster.RasterPlan;
import org.dfra.behaviors.raster.Region;
import org.dfra.sim.world.description.WorldDescription;

/**
 * A search: world, robots and region.
 *
 * @param world of the robots
 * @param robots their XML, in the order in which they search: the second searches in the opposite
 *     direction, and so on
 * @param region the region to search
 * @param swath width of the strip that a robot sees, metres
 * @param spacing from lane to lane, metres
 */
public record Scenario(
    WorldDescription world, List<Path> robots, Region region, double swath, double spacing) {

  public Scenario {
    robots = List.copyOf(robots);
  }

  /** The lanes as the first robot drives them. */
  public RasterPlan plan() {
    return RasterPlan.of(region, swath, spacing, RasterPlan.NORTHWARD);
  }

  /** The lanes as a robot drives them, counted from 0. */
  public RasterPlan plan(int robot) {
    return robot % 2 == 0 ? plan() : plan().reversed();
  }

  /** The same in another world. */
  public Scenario withWorld(WorldDescription other) {
    return new Scenario(other, robots, region, swath, spacing);
  }
}
