package org.dfra.report.plot;

import java.awt.Color;
import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.font.FontRenderContext;
import java.awt.geom.AffineTransform;
import org.dfra.text.PrintableText;

/** Text on panels: fonts, widths, and alignment. */
final class PanelText {

  static final Font TITLE = font(Font.BOLD, 20);
  static final Font HEADING = font(Font.BOLD, 14);
  static final Font PLAIN = font(Font.PLAIN, 12);
  static final Font STRONG = font(Font.BOLD, 12);
  static final Font SMALL = font(Font.PLAIN, 11);

  private static final FontRenderContext CONTEXT = new FontRenderContext(null, true, true);

  private PanelText() {}

  /** Alignment of a text at its position. */
  enum Side {
    /** The position is its left end. */
    LEFT,
    /** The position is its middle. */
    MIDDLE,
    /** The position is its right end. */
    RIGHT
  }

  private static Font font(int style, int size) {
    return new Font(Font.SANS_SERIF, style, size);
  }

  /**
   * Checks that there is a font.
   *
   * @throws NoFontException if there is none
   */
  static void require() {
    try {
      Object unused = PLAIN.getFamily();
    } catch (RuntimeException | LinkageError | InternalError e) { // Java reports it in several ways
      throw new NoFontException(e);
    }
  }

  /** Its width, in pixels. */
  static double width(String text, Font font) {
    return font.getStringBounds(text, CONTEXT).getWidth();
  }

  /** Height of its capital letters, in pixels. */
  static double height(Font font) {
    return font.createGlyphVector(CONTEXT, "H").getVisualBounds().getHeight();
  }

  /** The text; if it is wider than the limit in pixels, its beginning and an ellipsis. */
  static String fitting(String whole, Font font, double width) {
    String text = printable(whole);
    if (width(text, font) <= width) {
      return text;
    }
    String cut = text;
    while (!cut.isEmpty() && width(cut + "…", font) > width) {
      cut = cut.substring(0, cut.offsetByCodePoints(cut.length(), -1)).stripTrailing();
    }
    return cut + "…";
  }

  /** The text without control characters and others that XML cannot contain. */
  static String printable(String text) {
    return PrintableText.name(text.replaceAll("\\R", " "));
  }

  /** Paints it with its baseline at this height. */
  static void paint(
      Graphics2D g, String whole, Font font, Color colour, double x, double y, Side side) {
    String text = printable(whole);
    if (text.isBlank()) {
      return;
    }
    double shift =
        switch (side) {
          case LEFT -> 0;
          case MIDDLE -> width(text, font) / 2;
          case RIGHT -> width(text, font);
        };
    g.setFont(font);
    g.setColor(colour);
    g.drawString(text, (float) (x - shift), (float) y);
  }

  /** Paints it rotated upwards, its baseline at x, its middle at y. */
  static void upwards(Graphics2D g, String text, Font font, Color colour, double x, double y) {
    AffineTransform before = g.getTransform();
    g.translate(x, y);
    g.rotate(-Math.PI / 2);
    paint(g, text, font, colour, 0, 0, Side.MIDDLE);
    g.setTransform(before);
  }
}
