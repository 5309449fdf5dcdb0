package org.dfra.behaviors.raster;

import org.locationtech.jts.geom.Geometry;
import org.locationtech.jts.geom.PrecisionModel;
import org.locationtech.jts.operation.overlayng.OverlayNG;

/**
 * Overlays areas on a grid of 0.1 µm. The operands share edges except for the last bits; with full
 * precision JTS 1.20 may then find an empty intersection of large overlaps. On a grid such edges
 * become identical.
 */
final class SnappedOverlay {

  private static final PrecisionModel GRID = new PrecisionModel(1e7); // grid steps per metre

  private SnappedOverlay() {}

  /** Intersection; lines and points of contact are dropped. */
  static Geometry intersection(Geometry one, Geometry other) {
    return cut(one, other, OverlayNG.INTERSECTION);
  }

  /** Difference. */
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
