package org.dfra.sim.world.description;

import org.dfra.core.config.Place;

/**
 * A mine that lies on the ground. Visible to cameras, below the beams of lasers.
 *
 * @param name unique in its world, in lower_snake_case
 * @param east of its centre, metres
 * @param north of its centre, metres
 * @param radius metres, above 0
 * @param height metres, above 0
 * @param thermalContrast temperature minus that of the ground around it, kelvin; colder is negative
 * @param colour 0xRRGGBB
 * @param place its source location
 */
public record MineDescription(
    String name,
    double east,
    double north,
    double radius,
    double height,
    double thermalContrast,
    int colour,
    Place place) {

  /** Of a mine against vehicles, metres. */
  public static final double RADIUS = 0.16;

  /** Of a mine against vehicles, metres. */
  public static final double HEIGHT = 0.1;

  /** In the afternoon of a sunny day, kelvin. */
  public static final double CONTRAST = 4;

  /** Olive. */
  public static final int COLOUR = 0x3F4526;

  /** Created in code, of the default size. */
  public MineDescription(String name, double east, double north) {
    this(name, east, north, RADIUS, HEIGHT, CONTRAST, COLOUR, Place.CODE);
  }
}
