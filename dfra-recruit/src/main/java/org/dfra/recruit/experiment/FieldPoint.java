package org.dfra.recruit.experiment;

/**
 * A point in the field.
 *
 * @param east of its south-west corner, metres
 * @param north of it, metres
 */
record FieldPoint(double east, double north) {

  double distance(FieldPoint other) {
    return Math.hypot(east - other.east, north - other.north);
  }

  /** Interpolates towards another point, 0 to 1. */
  FieldPoint towards(FieldPoint other, double share) {
    return new FieldPoint(
        east + share * (other.east - east), north + share * (other.north - north));
  }
}
