package org.dfra.app.plot;

import java.awt.Color;
import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.font.FontRenderContext;
import java.awt.geom.AffineTransform;
import org.dfra.text.PrintableText;

/** Text on panels: its fonts, how wide it is, and where it stands. */
final class PanelText {

  static final Font TITLE = font(Font.BOLD, 20);
  static final Font HEADING = font(Font.BOLD, 14);
  static final Font PLAIN = font(Font.PLAIN, 12);
  static final Font STRONG = font(Font.BOLD, 12);
  static final Font SMALL = font(Font.PLAIN, 11);

  private static final FontRenderContext CONTEXT = new FontRenderContext(null, true, true);

  private PanelText() {}

  /** Where a text stands at its place. */
  enum Side {
    /** It begins there. */
    LEFT,
    /** Its middle is there. */
    MIDDLE,
    /** It ends there. */
    RIGHT
  }

  private static Font font(int style, int size) {
    return new Font(Font.SANS_SERIF, style, size);
  }

  /**
   * Makes sure that there is a font.
   *
   * @throws NoFontException if there is none
   */
  static void require() {
    try {
      Object unused = PLAIN.getFamily();
    } catch (RuntimeException | LinkageError | InternalError e) { // as it happens to find out
      throw new NoFontException(e);
    }
  }

  /** Its width, in pixels. */
  static double width(String text, Font font) {
    return font.getStringBounds(text, CONTEXT).getWidth();
  }

  /** How far its capital letters reach above its baseline, in pixels. */
  static double height(Font font) {
    return font.createGlyphVector(CONTEXT, "H").getVisualBounds().getHeight();
  }

  /** The text, or where it is wider than so many pixels, its beginning and an ellipsis. */
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

  /** The text without control characters, which XML cannot hold, and the like. */
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

  /** Paints it upwards, its baseline at x, its middle at y. */
  static void upwards(Graphics2D g, String text, Font font, Color colour, double x, double y) {
    AffineTransform before = g.getTransform();
    g.translate(x, y);
    g.rotate(-Math.PI / 2);
    paint(g, text, font, colour, 0, 0, Side.MIDDLE);
    g.setTransform(before);
  }
}
