package org.dfra.report.plot;

import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.Point;
import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.List;

/** Panels painted to bitmaps, to be looked at by tests. */
final class Bitmaps {

  private static final int WHITE = Color.WHITE.getRGB();

  private Bitmaps() {}

  /** The panel with paper all around it. */
  static BufferedImage of(Panel panel, int width, int height, int around) {
    BufferedImage image =
        new BufferedImage(width + 2 * around, height + 2 * around, BufferedImage.TYPE_INT_RGB);
    Graphics2D g = image.createGraphics();
    g.addRenderingHints(Page.HINTS);
    g.setColor(Color.WHITE);
    g.fillRect(0, 0, image.getWidth(), image.getHeight());
    g.translate(around, around);
    panel.paint(g, width, height);
    g.dispose();
    return image;
  }

  /** The inked pixels that are nearer to the image's edge than this. */
  static List<Point> inkAtEdge(BufferedImage image, int distance) {
    List<Point> inked = new ArrayList<>();
    for (int y = 0; y < image.getHeight(); y++) {
      for (int x = 0; x < image.getWidth(); x++) {
        boolean isEdge =
            Math.min(x, image.getWidth() - 1 - x) < distance
                || Math.min(y, image.getHeight() - 1 - y) < distance;
        if (isEdge && image.getRGB(x, y) != WHITE) {
          inked.add(new Point(x, y));
        }
      }
    }
    return inked;
  }

  /** How many pixels have this colour. */
  static long count(BufferedImage image, Color colour) {
    long found = 0;
    for (int y = 0; y < image.getHeight(); y++) {
      for (int x = 0; x < image.getWidth(); x++) {
        found += image.getRGB(x, y) == colour.getRGB() ? 1 : 0;
      }
    }
    return found;
  }
}
