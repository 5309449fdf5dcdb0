package org.dfra.behaviors.raster;

import org.dfra.geometry.Leg;
import org.dfra.geometry.LocalPosition;

/**
 * A straight lane of a raster, as it is driven.
 *
 * @param from where it begins, in the region's frame, ENU, metres, up 0
 * @param to where it ends, likewise
 * @param leg the same on the earth, WGS84, height 0
 * @param waypoint which of the plan's waypoints it begins at, the first is 0; it ends at the next
 */
public record Lane(LocalPosition from, LocalPosition to, Leg leg, int waypoint) {

  /** Metres. */
  public double length() {
    return Math.hypot(to.east() - from.east(), to.north() - from.north());
  }
}
