package org.dfra.behaviors.raster;

import org.dfra.behavior.BehaviorStatus;

/** How paths, and what has them driven, tell people at which waypoint they are. */
public final class WaypointText {

  private WaypointText() {}

  /**
   * {@code waypoint 3 of 8}.
   *
   * @param done waypoints that are dealt with; the next is the one that is meant
   * @param all waypoints there are
   */
  public static String position(int done, int all) {
    return "waypoint " + Math.min(all, done + 1) + " of " + all;
  }

  /**
   * What a path does, with the number of its waypoint among those of a longer way that it is a part
   * of.
   *
   * @param path what the path says
   * @param before waypoints of the longer way before the path's first
   * @param all waypoints of the longer way
   */
  public static String positionInWhole(BehaviorStatus path, int before, int all) {
    String own = position(path.completedParts(), path.totalParts()) + ":";
    return path.totalParts() > 0 && path.activity().startsWith(own)
        ? position(before + path.completedParts(), all)
            + path.activity().substring(own.length() - 1)
        : path.activity();
  }
}
