package org.dfra.behaviors.waypoint;

import org.dfra.behavior.BehaviorStatus;

/** Formats the progress of a path, by waypoints, for people. */
public final class WaypointText {

  private WaypointText() {}

  /**
   * {@code waypoint 3 of 8}.
   *
   * @param done finished waypoints; the text names the next one
   * @param all number of waypoints
   */
  public static String position(int done, int all) {
    return "waypoint " + Math.min(all, done + 1) + " of " + all;
  }

  /**
   * The status text of a path, with its waypoint numbered in a longer path that contains it.
   *
   * @param path status text of the path
   * @param before waypoints of the longer path before the path's first
   * @param all number of waypoints of the longer path
   */
  public static String positionInWhole(BehaviorStatus path, int before, int all) {
    String own = position(path.completedParts(), path.totalParts()) + ":";
    return path.totalParts() > 0 && path.activity().startsWith(own)
        ? position(before + path.completedParts(), all)
            + path.activity().substring(own.length() - 1)
        : path.activity();
  }
}
