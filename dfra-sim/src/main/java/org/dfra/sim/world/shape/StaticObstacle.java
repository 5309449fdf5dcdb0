package org.dfra.sim.world.shape;

import org.dfra.sim.world.shape.PlanarShape.Disc;
import org.dfra.sim.world.shape.PlanarShape.Polygon;
import org.dfra.sim.world.shape.PlanarShape.Vertex;

/**
 * A static obstacle on the ground. Immutable.
 *
 * <p>Its coordinates are in arrays, since beams and bodies are tested against it a million times a
 * second.
 */
public final class StaticObstacle {

  private final String name;
  private final PlanarShape outline;
  private final double height;
  private final double reflectivity;
  final Disc bounds;
  final double[] east; // of the corners, counter-clockwise; none for a disc
  final double[] north;

  /**
   * @param height metres above the ground, above 0
   * @param reflectivity part of a laser's light that it returns, 0 to 1
   */
  public StaticObstacle(String name, PlanarShape outline, double height, double reflectivity) {
    this.name = name;
    this.outline = outline;
    this.height = height;
    this.reflectivity = reflectivity;
    this.bounds = outline.bounds();
    if (outline instanceof Polygon polygon) {
      this.east = polygon.corners().stream().mapToDouble(Vertex::east).toArray();
      this.north = polygon.corners().stream().mapToDouble(Vertex::north).toArray();
    } else {
      this.east = new double[0];
      this.north = new double[0];
    }
  }

  /** Its name. */
  public String name() {
    return name;
  }

  /** Its outline. */
  public PlanarShape outline() {
    return outline;
  }

  /** Metres above the ground. */
  public double height() {
    return height;
  }

  /** Part of a laser's light that it returns, 0 to 1. */
  public double reflectivity() {
    return reflectivity;
  }

  boolean isDisc() {
    return east.length == 0;
  }
}
