package org.dfra.sim.world.description;

import org.dfra.core.config.Place;
import org.dfra.sim.world.shape.Disc;
import org.dfra.sim.world.shape.PlanarShape;

/**
 * An obstacle: a post, a hedge, a house.
 *
 * @param name unique in its world, in lower_snake_case
 * @param footprint seen from above, metres east and north of the datum
 * @param height metres, above 0
 * @param reflectivity part of a laser's light that it returns, 0 to 1; 0 is invisible
 * @param colour 0xRRGGBB
 * @param place its source location
 */
public record ObstacleDescription(
    String name,
    PlanarShape footprint,
    double height,
    double reflectivity,
    int colour,
    Place place) {

  /** Default reflectivity. */
  public static final double REFLECTIVITY = 0.4;

  /** Created in code, with default reflectivity and colour. */
  public ObstacleDescription(String name, PlanarShape outline, double height) {
    this(name, outline, height, REFLECTIVITY, colour(outline), Place.CODE);
  }

  /** Default colour: a post as weathered wood, others as a hedge. */
  public static int colour(PlanarShape outline) {
    return outline instanceof Disc ? 0x9A8F7D : 0x35562A;
  }
}
