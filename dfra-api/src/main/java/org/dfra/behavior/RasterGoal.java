package org.dfra.behavior;

import java.util.List;
import org.dfra.geometry.GeoPosition;

/**
 * To observe every point of a region.
 *
 * @param region the corners of a polygon in order, frame WGS84, the first not repeated; at least
 *     three
 * @param swath width of the strip that the robot observes along its path, metres, above 0
 * @param spacing distance between lanes, metres, above 0 and at most the swath; the difference is a
 *     margin for cross-track error
 * @param reversed whether the lanes are driven in reverse order, each in the opposite direction
 */
public record RasterGoal(List<GeoPosition> region, double swath, double spacing, boolean reversed)
    implements Goal {

  public RasterGoal {
    region = List.copyOf(region);
    if (!(swath > 0 && spacing > 0 && spacing <= swath && Double.isFinite(swath))) {
      throw new IllegalArgumentException(
          "lanes " + spacing + " m apart do not cover with a swath of " + swath + " m");
    }
  }
}
