package org.dfra.recruit.experiment;

/**
 * Lanes over a rectangle, driven back and forth repeatedly. Lanes run north and south; frame east,
 * north, metres.
 */
final class RasterRoute {

  private final double west;
  private final double south;
  private final double height;
  private final double spacing;
  private final int lanes;

  /**
   * @param width of the rectangle, metres
   * @param height likewise
   * @param spacing between lanes, metres
   */
  RasterRoute(double west, double south, double width, double height, double spacing) {
    this.west = west;
    this.south = south;
    this.height = height;
    this.spacing = spacing;
    this.lanes = (int) (width / spacing) + 1;
  }

  /** Length from one end to the other, metres. */
  double length() {
    return lanes * height + (lanes - 1) * spacing;
  }

  /** The position after a driven distance, metres, not negative. */
  FieldPoint at(double way) {
    double there = way % (2 * length());
    double along = there <= length() ? there : 2 * length() - there;
    int lane = Math.min(lanes - 1, (int) (along / (height + spacing)));
    double inLane = along - lane * (height + spacing);
    double up = Math.min(inLane, height);
    double over = Math.max(0, inLane - height);
    return new FieldPoint(west + lane * spacing + over, south + (lane % 2 == 0 ? up : height - up));
  }
}
