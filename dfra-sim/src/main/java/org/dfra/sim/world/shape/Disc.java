package org.dfra.sim.world.shape;

/**
 * A disc, such as a post seen from above.
 *
 * @param east of its centre, metres
 * @param north of its centre, metres
 * @param radius metres, above 0
 */
public record Disc(double east, double north, double radius) implements PlanarShape {

  public Disc {
    if (!Double.isFinite(east) || !Double.isFinite(north)) {
      throw new IllegalArgumentException("the centre " + east + "," + north + " is not finite");
    }
    if (!(radius > 0 && radius < Double.POSITIVE_INFINITY)) {
      throw new IllegalArgumentException("the radius " + radius + " m is not above 0");
    }
  }

  @Override
  public boolean contains(double east, double north) {
    double x = east - this.east;
    double y = north - this.north;
    return x * x + y * y <= radius * radius;
  }

  @Override
  public Disc bounds() {
    return this;
  }
}
