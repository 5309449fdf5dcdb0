package org.dfra.geometry;

import java.io.Serializable;

/**
 * A straight path over the ground.
 *
 * @param from where it begins, frame WGS84; its height is ignored
 * @param to where it ends, likewise
 */
public record Leg(GeoPosition from, GeoPosition to) implements Serializable {

  /** Metres from its beginning to its end. */
  public double length() {
    return from.groundDistance(to);
  }
}
