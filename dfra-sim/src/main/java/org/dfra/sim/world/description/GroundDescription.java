package org.dfra.sim.world.description;

import org.dfra.core.config.Place;

/**
 * The ground: a plane that everything stands on. The field is the part of it from the datum so far
 * east and north; robots can leave it.
 *
 * @param sizeEast of the field, east of the datum, metres, above 0 to 100 km
 * @param sizeNorth of the field, north of the datum, metres, above 0 to 100 km
 * @param roughness σ of the slope that tilts a robot's body, radians, 0 to 0.2; 0 is a plane
 * @param place where it was written
 */
public record GroundDescription(double sizeEast, double sizeNorth, double roughness, Place place) {

  /** Even ground. */
  public GroundDescription(double width, double depth) {
    this(width, depth, 0, Place.CODE);
  }
}
