package org.dfra.behaviors.raster;

import java.util.List;
import java.util.Locale;
import org.dfra.behavior.GoalRefusedException;
import org.dfra.geometry.GeoPosition;
import org.dfra.geometry.LocalFrame;
import org.dfra.geometry.LocalPosition;
import org.locationtech.jts.algorithm.LineIntersector;
import org.locationtech.jts.algorithm.RobustLineIntersector;
import org.locationtech.jts.geom.Coordinate;
import org.locationtech.jts.geom.Polygon;
import org.locationtech.jts.operation.valid.IsValidOp;

/** Validates the corners of a region. Messages count them from 1. */
final class RegionValidation {

  private RegionValidation() {}

  /** Rejects corners that are too far apart for one region. */
  static void requireWithinExtent(List<GeoPosition> corners, Polygon polygon) {
    Coordinate[] at = polygon.getCoordinates();
    for (int i = 0; i < corners.size(); i++) {
      for (int j = 0; j < i; j++) {
        double distance = at[i].distance(at[j]);
        if (distance > Region.WIDEST) {
          // far away the plane is inaccurate, so the reported distance is that through the earth
          double through = corners.get(i).groundDistance(corners.get(j));
          throw new GoalRefusedException(
              String.format(
                  Locale.ROOT,
                  "corners %d and %d of the region, %s and %s, are %.1f km apart, more than"
                      + " %.0f km; correct them, and check that latitude and longitude are not"
                      + " swapped",
                  j + 1,
                  i + 1,
                  corners.get(j).latitudeAndLongitude(),
                  corners.get(i).latitudeAndLongitude(),
                  through / 1000,
                  Region.WIDEST / 1000));
        }
      }
    }
  }

  /** Rejects an outline that crosses or touches itself. */
  static void requireSimple(List<GeoPosition> corners, Polygon polygon) {
    IsValidOp validity = new IsValidOp(polygon);
    if (validity.isValid()) {
      return;
    }
    Coordinate[] at = polygon.getCoordinates();
    LineIntersector lines = new RobustLineIntersector();
    int n = corners.size();
    for (int i = 0; i < n; i++) {
      for (int j = i + 1; j < n; j++) {
        lines.computeIntersection(at[i], at[i + 1], at[j], at[j + 1]);
        boolean areNeighbours = j == i + 1 || i == 0 && j == n - 1;
        if (lines.getIntersectionNum() > (areNeighbours ? 1 : 0)) {
          Coordinate where = lines.getIntersection(lines.getIntersectionNum() - 1);
          throw new GoalRefusedException(crossing(corners, where, i, j));
        }
      }
    }
    throw new GoalRefusedException(
        "the outline of the region is not a polygon ("
            + validity.getValidationError()
            + "); give the corners in their order around it");
  }

  private static String crossing(List<GeoPosition> corners, Coordinate where, int i, int j) {
    int n = corners.size();
    GeoPosition there =
        new LocalFrame(corners.get(0)).toGeo(new LocalPosition(where.x, where.y, 0));
    return String.format(
        Locale.ROOT,
        "the outline of the region crosses itself at %s, where the edge from corner %d to corner %d"
            + " meets that from corner %d to corner %d; give the corners in their order around it",
        there.latitudeAndLongitude(),
        i + 1,
        i + 2,
        j + 1,
        (j + 1) % n + 1);
  }
}
