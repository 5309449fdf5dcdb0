package org.dfra.behaviors.raster;

import org.dfra.geometry.Leg;
import org.dfra.geometry.LocalPosition;

/**
 * A straight lane of a raster, as it is driven.
 *
 * @param from start, in the region's frame, ENU, metres, up 0
 * @param to end, likewise
 * @param leg the same in WGS84, height 0
 * @param waypoint index of the plan's waypoint at its start, from 0; it ends at the next
 */
public record Lane(LocalPosition from, LocalPosition to, Leg leg, int waypoint) {

  /** Metres. */
  public double length() {
    return Math.hypot(to.east() - from.east(), to.north() - from.north());
  }
}
