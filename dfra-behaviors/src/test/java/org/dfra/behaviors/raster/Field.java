package org.dfra.behaviors.raster;

import java.util.ArrayList;
import java.util.List;
import org.dfra.geometry.GeoPosition;
import org.dfra.geometry.LocalFrame;
import org.dfra.geometry.LocalPosition;

/** Regions by metres. */
final class Field {

  private Field() {}

  /** The positions at metres east and north, in turn, of 48° north and 11° east. */
  static List<GeoPosition> positions(double... eastAndNorth) {
    LocalFrame frame = new LocalFrame(new GeoPosition(48, 11, 0));
    List<GeoPosition> positions = new ArrayList<>();
    for (int i = 0; i < eastAndNorth.length; i += 2) {
      positions.add(frame.toGeo(new LocalPosition(eastAndNorth[i], eastAndNorth[i + 1], 0)));
    }
    return positions;
  }

  static Region region(double... eastAndNorth) {
    return Region.of(positions(eastAndNorth));
  }

  static Region rectangle(double width, double depth) {
    return region(0, 0, width, 0, width, depth, 0, depth);
  }
}
