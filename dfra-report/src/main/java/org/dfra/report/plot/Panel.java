package org.dfra.report.plot;

import java.awt.Graphics2D;

/** An image in a rectangle of a {@link Page}. */
@FunctionalInterface
public interface Panel {

  /**
   * Paints itself from (0, 0), the rectangle's upper left corner, to (width, height).
   *
   * @param width in pixels
   * @param height in pixels
   */
  void paint(Graphics2D g, int width, int height);
}
