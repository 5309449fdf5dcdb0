package org.dfra.behavior;

import java.util.List;
import org.dfra.geometry.GeoPosition;

/**
 * To have seen every point of a region.
 *
 * @param region the corners of a polygon in order, frame WGS84, the first not repeated; three at
 *     least
 * @param swath how wide a strip the robot sees on its way, metres, above 0
 * @param spacing from one lane to the next, metres, above 0 and at most the swath; the rest is for
 *     what the robot strays from its lane
 * @param reversed whether the last lane comes first and each is driven the other way
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
