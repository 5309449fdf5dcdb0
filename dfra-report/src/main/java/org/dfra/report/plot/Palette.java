package org.dfra.report.plot;

import java.awt.BasicStroke;
import java.awt.Color;
import java.util.List;

/**
 * Colours and strokes that colour-blind readers can distinguish too, and that contrast with white:
 * those of Okabe and Ito ("Color universal design", 2008) without their yellow.
 */
final class Palette {

  static final Color PAPER = Color.WHITE;
  static final Color INK = new Color(0x222222);
  static final Color FAINT = new Color(0xD9D9D9);
  static final Color BAND = new Color(0x70, 0x70, 0x70, 48);
  static final Color VEIL = new Color(255, 255, 255, 150);
  static final Color HEAD = new Color(0xF0F0F0);
  static final Color GREY = new Color(0x707070);

  private static final List<Color> COLOURS =
      List.of(
          new Color(0x0072B2), // blue
          new Color(0xD55E00), // vermilion
          new Color(0x009E73), // green
          new Color(0xCC79A7), // purple
          new Color(0xE69F00), // orange
          new Color(0x56B4E9), // sky
          Color.BLACK);

  /** For frames and ticks. */
  static final BasicStroke THIN = new BasicStroke(1);

  private static final float WIDTH = 1.8f;
  private static final float[][] DASHES = {{}, {7, 3}, {2, 3}, {9, 3, 2, 3}};

  private Palette() {}

  /** The colour of the n-th name, from 0. */
  static Color colour(int number) {
    return COLOURS.get(number % COLOURS.size());
  }

  /** The stroke of the n-th name, from 0: if colours repeat, the dashes differ. */
  static BasicStroke stroke(int number) {
    float[] dashes = DASHES[number / COLOURS.size() % DASHES.length];
    return dashes.length == 0
        ? new BasicStroke(WIDTH, BasicStroke.CAP_BUTT, BasicStroke.JOIN_ROUND)
        : new BasicStroke(WIDTH, BasicStroke.CAP_BUTT, BasicStroke.JOIN_ROUND, 10, dashes, 0);
  }

  /** The same, half transparent, for series in the background. */
  static Color faint(Color colour) {
    return new Color(colour.getRed(), colour.getGreen(), colour.getBlue(), 80);
  }

  /** The same, almost transparent, to fill areas. */
  static Color fill(Color colour) {
    return new Color(colour.getRed(), colour.getGreen(), colour.getBlue(), 56);
  }
}
