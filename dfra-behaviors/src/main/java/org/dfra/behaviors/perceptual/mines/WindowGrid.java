package org.dfra.behaviors.perceptual.mines;

import org.jspecify.annotations.Nullable;

/**
 * The detection windows of all positions in front of a robot that a camera sees, on a lattice of
 * {@value #STEP} m. Created once for a camera and valid as long as its mount does not change.
 * Immutable.
 */
final class WindowGrid {

  /** Spacing of the lattice, metres. */
  static final double STEP = 0.05;

  private static final double SIDEWAYS = 2.5; // metres to each side

  private final PinholeCamera camera;
  private final double near;
  private final int rows;
  private final int columns = 2 * (int) Math.round(SIDEWAYS / STEP) + 1;
  private final @Nullable DetectionWindow[] windows;

  /**
   * @param near minimum distance, metres forward of the base
   * @param far maximum distance, likewise
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

  /** Number of positions, visible or not. */
  int size() {
    return windows.length;
  }

  /** Number of positions in a row of equal distance. */
  int columns() {
    return columns;
  }

  /** The position of that index. */
  GroundPoint point(int index) {
    return new GroundPoint(near + index / columns * STEP, (index % columns) * STEP - SIDEWAYS);
  }

  /** Its window; null where visibility is insufficient. */
  @Nullable DetectionWindow at(int index) {
    return windows[index];
  }

  /** Whether a mine there would be sufficiently visible. */
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
