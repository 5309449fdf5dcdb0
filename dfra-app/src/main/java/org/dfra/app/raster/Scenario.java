package org.dfra.app.raster;

import java.nio.file.Path;
import java.util.List;
import org.dfra.behaviors.raster.RasterPlan;
import org.dfra.behaviors.raster.Region;
import org.dfra.sim.world.description.WorldDescription;

/**
 * What is to be searched, where, and by whom.
 *
 * @param world what they move in
 * @param robots their XML, in the order in which they search: the second goes the other way round,
 *     and so on
 * @param region what is to be searched
 * @param swath how wide a strip a robot sees, metres
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
