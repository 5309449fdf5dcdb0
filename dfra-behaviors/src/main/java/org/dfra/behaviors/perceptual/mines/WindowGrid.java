package org.dfra.behaviors.perceptual.mines;

import org.jspecify.annotations.Nullable;

/**
 * The windows of all places before a robot that a camera sees, on a lattice of {@value #STEP} m.
 * Made once for a camera and kept as long as that does not move on its robot. Immutable.
 */
final class WindowGrid {

  /** From place to place, metres. */
  static final double STEP = 0.05;

  private static final double SIDEWAYS = 2.5; // metres to each side

  private final PinholeCamera camera;
  private final double near;
  private final int rows;
  private final int columns = 2 * (int) Math.round(SIDEWAYS / STEP) + 1;
  private final @Nullable DetectionWindow[] windows;

  /**
   * @param near nearest place, metres forward of the base
   * @param far farthest, likewise
   */
  WindowGrid(PinholeCamera camera, MineModel target, double near, double far) {
    this.camera = camera;
    this.near = near;
    this.rows = (int) ((far - near) / STEP) + 1;
    this.windows = new DetectionWindow[rows * columns];
    for (int i = 0; i < windows.length; i++) {
      GroundPoint at = point(i);
      windows[i] = DetectionWindow.at(at.x(), at.y(), target, camera);
    }
  }

  PinholeCamera camera() {
    return camera;
  }

  /** Number of places, seen or not. */
  int size() {
    return windows.length;
  }

  /** Number of places in a row of equal distance. */
  int columns() {
    return columns;
  }

  /** The place of that number. */
  GroundPoint point(int index) {
    return new GroundPoint(near + index / columns * STEP, (index % columns) * STEP - SIDEWAYS);
  }

  /** Its window; null where it is not seen well enough. */
  @Nullable DetectionWindow at(int index) {
    return windows[index];
  }

  /** Whether a mine there would be seen well enough. */
  boolean covers(GroundPoint spot) {
    long row = Math.round((spot.x() - near) / STEP);
    long column = Math.round((spot.y() + SIDEWAYS) / STEP);
    return row >= 0
        && row < rows
        && column >= 0
        && column < columns
        && windows[(int) (row * columns + column)] != null;
  }
}
