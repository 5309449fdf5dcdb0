package org.dfra.sim.world.shape;

/** The outline of an object, seen from above. */
public sealed interface PlanarShape permits Disc, Polygon {

  /** Whether a point lies in it or on its edge. */
  boolean contains(double east, double north);

  /** A bounding disc. */
  Disc bounds();
}
