package org.dfra.behaviors.perceptual.mines;

import java.util.ArrayList;
import java.util.List;
import org.dfra.behaviors.perceptual.mines.ImageMineDetectorSettings.MineModel;
import org.dfra.behaviors.perceptual.mines.MineObservation.GroundPoint;
import org.dfra.behaviors.perceptual.mines.PinholeCamera.Pixel;
import org.jspecify.annotations.Nullable;

/**
 * The pixels of a mine at a given position in an image, and those around it.
 *
 * <pre>
 *          o  o  o
 *       o           o
 *      o    .----.   o     inside: the mine without its edge
 *      o    | in |   o     o: sixteen boxes around it
 *      o    '----'   o
 *       o           o
 *          o  o  o
 * </pre>
 *
 * @param inside the mine
 * @param surroundings the boxes around it that lie in the image, at least ten
 */
record DetectionWindow(
    DetectionWindow.PixelRect inside, List<DetectionWindow.PixelRect> surroundings) {

  private static final int BOXES = 16;
  private static final int FEWEST = 10;
  private static final int CORNERS = 8; // of the circles that represent the cylinder
  private static final double INSIDE = 0.75; // of the mine's outline
  private static final double AWAY = 2.2; // from the centre to the boxes', by half the outline
  private static final double BESIDE = 0.5; // half of each box, by half the outline
  private static final double NARROWEST = 3; // half the outline's width, pixels
  private static final double LOWEST = 1.5; // half the outline's height, pixels

  DetectionWindow {
    surroundings = List.copyOf(surroundings);
  }

  /**
   * For a mine at a position.
   *
   * @param x forward of the base, metres
   * @param y to the left, metres
   * @return null where it is not wholly visible, too small, or too few boxes are visible
   */
  static @Nullable DetectionWindow at(double x, double y, MineModel target, PinholeCamera camera) {
    double left = Double.POSITIVE_INFINITY;
    double right = Double.NEGATIVE_INFINITY;
    double top = Double.POSITIVE_INFINITY;
    double bottom = Double.NEGATIVE_INFINITY;
    for (int i = 0; i < 2 * CORNERS; i++) {
      double angle = 2 * Math.PI * (i / 2) / CORNERS;
      Pixel pixel =
          camera.project(
              x + target.radius() * Math.cos(angle),
              y + target.radius() * Math.sin(angle),
              i % 2 * target.height());
      if (pixel == null) {
        return null;
      }
      left = Math.min(left, pixel.column());
      right = Math.max(right, pixel.column());
      top = Math.min(top, pixel.row());
      bottom = Math.max(bottom, pixel.row());
    }
    double column = (left + right) / 2;
    double row = (top + bottom) / 2;
    double halfWidth = (right - left) / 2;
    double halfHeight = (bottom - top) / 2;
    if (halfWidth < NARROWEST
        || halfHeight < LOWEST
        || !PixelRect.around(column, row, halfWidth, halfHeight)
            .fitsWithin(camera.width(), camera.height())) {
      return null;
    }
    List<PixelRect> around = surroundings(new Pixel(column, row), halfHeight, y, target, camera);
    return around.size() < FEWEST
        ? null
        : new DetectionWindow(
            PixelRect.around(column, row, INSIDE * halfWidth, INSIDE * halfHeight), around);
  }

  /** Boxes in ground coordinates: a straight line on the ground passes through opposite boxes. */
  private static List<PixelRect> surroundings(
      Pixel middle, double halfHeight, double y, MineModel target, PinholeCamera camera) {
    List<PixelRect> around = new ArrayList<>();
    for (int i = 0; i < BOXES; i++) {
      double angle = 2 * Math.PI * i / BOXES;
      double row = middle.row() - AWAY * halfHeight * Math.cos(angle);
      GroundPoint ground = camera.backProject(new Pixel(middle.column(), row), 0);
      if (ground == null) {
        continue;
      }
      double aside = AWAY * target.radius() * Math.sin(angle);
      double half = BESIDE * target.radius();
      Pixel left = camera.project(ground.x(), y + aside + half, 0);
      Pixel right = camera.project(ground.x(), y + aside - half, 0);
      if (left == null || right == null) {
        continue;
      }
      PixelRect box =
          PixelRect.around(
              (left.column() + right.column()) / 2,
              row,
              Math.abs(right.column() - left.column()) / 2,
              BESIDE * halfHeight);
      if (box.fitsWithin(camera.width(), camera.height())) {
        around.add(box);
      }
    }
    return around;
  }

  /**
   * A rectangle of pixels.
   *
   * @param left column of the first
   * @param top row of the first, counted from above
   * @param right column after the last
   * @param bottom row below the last
   */
  record PixelRect(int left, int top, int right, int bottom) {

    /** The pixels whose centres lie around a point, at least one. */
    static PixelRect around(double column, double row, double halfWidth, double halfHeight) {
      int left = (int) Math.floor(column - halfWidth + 0.5);
      int top = (int) Math.floor(row - halfHeight + 0.5);
      int right = Math.max(left + 1, (int) Math.floor(column + halfWidth + 0.5));
      int bottom = Math.max(top + 1, (int) Math.floor(row + halfHeight + 0.5));
      return new PixelRect(left, top, right, bottom);
    }

    boolean fitsWithin(int width, int height) {
      return left >= 0 && top >= 0 && right <= width && bottom <= height;
    }

    int pixels() {
      return (right - left) * (bottom - top);
    }
  }

  /**
   * The detection windows of all positions in front of a robot that a camera sees, on a lattice of
   * {@value #STEP} m. Created once for a camera and valid as long as its mount does not change.
   * Immutable.
   */
  static final class WindowGrid {

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
}
