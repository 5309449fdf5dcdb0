package org.dfra.recruit.experiment;

import org.dfra.geometry.GeoPosition;
import org.dfra.geometry.LocalFrame;
import org.dfra.geometry.LocalPosition;

/** The field: a square. */
final class ExperimentField {

  /** Length of a side, metres. */
  static final double SIDE = 100;

  /** From corner to corner, metres. */
  static final double DIAGONAL = SIDE * Math.sqrt(2);

  private static final LocalFrame FRAME = new LocalFrame(new GeoPosition(28.06, -82.41, 0));

  private ExperimentField() {}

  static FieldPoint toField(GeoPosition place) {
    LocalPosition local = FRAME.toLocal(place);
    return new FieldPoint(local.east(), local.north());
  }

  static GeoPosition toEarth(FieldPoint point) {
    return FRAME.toGeo(new LocalPosition(point.east(), point.north(), 0));
  }

  static boolean contains(FieldPoint point) {
    return point.east() >= 0 && point.east() <= SIDE && point.north() >= 0 && point.north() <= SIDE;
  }
}
