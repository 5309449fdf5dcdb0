package org.dfra.behaviors.perceptual.mines;

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
