package org.dfra.behaviors.raster;

import org.locationtech.jts.geom.Geometry;
import org.locationtech.jts.geom.PrecisionModel;
import org.locationtech.jts.operation.overlayng.OverlayNG;

/**
 * Cuts areas on a grid of 0.1 µm. What is cut here shares edges with what it is cut from, all but
 * for the last bits, and with all bits JTS 1.20 may find nothing in common where there is much. On
 * a grid such edges become the same.
 */
final class SnappedOverlay {

  private static final PrecisionModel GRID = new PrecisionModel(1e7); // steps to a metre

  private SnappedOverlay() {}

  /** What lies in both; lines and points where they merely touch are left out. */
  static Geometry intersection(Geometry one, Geometry other) {
    return cut(one, other, OverlayNG.INTERSECTION);
  }

  /** What of the one does not lie in the other. */
  static Geometry difference(Geometry one, Geometry other) {
    return cut(one, other, OverlayNG.DIFFERENCE);
  }

  private static Geometry cut(Geometry one, Geometry other, int operation) {
    OverlayNG overlay = new OverlayNG(one, other, GRID, operation);
    overlay.setStrictMode(true); // areas alone, or lines and points where there are no areas
    Geometry result = overlay.getResult();
    return result.getDimension() < 2 ? one.getFactory().createPolygon() : result;
  }
}
