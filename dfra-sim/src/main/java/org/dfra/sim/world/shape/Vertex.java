package org.dfra.sim.world.shape;

/**
 * A corner of a polygon.
 *
 * @param east metres
 * @param north metres
 */
public record Vertex(double east, double north) {

  public Vertex {
    if (!Double.isFinite(east) || !Double.isFinite(north)) {
      throw new IllegalArgumentException("the corner " + east + "," + north + " is not finite");
    }
  }
}
