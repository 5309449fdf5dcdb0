package org.dfra.sim.world.description;

import org.dfra.core.config.Place;

/**
 * The ground: a plane. The field is its part from the datum to the given distances east and north;
 * robots can leave it.
 *
 * @param sizeEast of the field, east of the datum, metres, above 0 to 100 km
 * @param sizeNorth of the field, north of the datum, metres, above 0 to 100 km
 * @param roughness σ of the slope that tilts a robot's body, radians, 0 to 0.2; 0 is a plane
 * @param place its source location
 */
public record GroundDescription(double sizeEast, double sizeNorth, double roughness, Place place) {

  /** Even ground. */
  public GroundDescription(double width, double depth) {
    this(width, depth, 0, Place.CODE);
  }
}
