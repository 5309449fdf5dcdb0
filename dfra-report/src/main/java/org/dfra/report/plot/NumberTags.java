package org.dfra.report.plot;

import java.awt.Graphics2D;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.awt.geom.Point2D;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.List;

/**
 * Numbers at points of a plot, each in a disc beside its point and joined to it. A disc covers
 * neither a point nor another disc, and is as near as possible. Confined to one thread.
 */
final class NumberTags {

  private static final double POINT = 2.5; // radius, pixels
  private static final double TAG = 9; // likewise
  private static final double NEAREST = 16; // from the point to the disc's middle
  private static final double STEP = 8;
  private static final int RINGS = 12;
  private static final int DIRECTIONS = 12;

  private final Rectangle2D area;
  private final List<Tag> all = new ArrayList<>();

  private record Tag(Point2D at, String number) {}

  /**
   * @param area that contains the discs
   */
  NumberTags(Rectangle2D area) {
    this.area = area;
  }

  /** Adds a number for a point in pixels. */
  void add(double x, double y, String number) {
    all.add(new Tag(new Point2D.Double(x, y), number));
  }

  /** The centres of the discs, in the order added; the first is placed first. */
  List<Point2D> discs() {
    List<Point2D> discs = new ArrayList<>();
    all.forEach(each -> discs.add(place(each.at(), discs)));
    return discs;
  }

  void paint(Graphics2D g) {
    g.setStroke(Palette.THIN);
    List<Point2D> discs = discs();
    for (int i = 0; i < discs.size(); i++) {
      Tag each = all.get(i);
      Point2D disc = discs.get(i);
      g.setColor(Palette.INK);
      g.draw(new Line2D.Double(each.at(), disc));
      g.fill(circle(each.at(), POINT));
    }
    double baseline = PanelText.height(PanelText.SMALL) / 2;
    for (int i = 0; i < discs.size(); i++) {
      Point2D disc = discs.get(i);
      g.setColor(Palette.PAPER);
      g.fill(circle(disc, TAG));
      g.setColor(Palette.INK);
      g.draw(circle(disc, TAG));
      PanelText.paint(
          g,
          all.get(i).number(),
          PanelText.SMALL,
          Palette.INK,
          disc.getX(),
          disc.getY() + baseline,
          PanelText.Side.MIDDLE);
    }
  }

  private static Ellipse2D circle(Point2D at, double radius) {
    return new Ellipse2D.Double(at.getX() - radius, at.getY() - radius, 2 * radius, 2 * radius);
  }

  /** Tries positions from the upper right, clockwise, and farther away with each round. */
  private Point2D place(Point2D at, List<Point2D> taken) {
    for (int ring = 0; ring < RINGS; ring++) {
      double far = NEAREST + ring * STEP;
      for (int i = 0; i < DIRECTIONS; i++) {
        double angle = 2 * Math.PI * i / DIRECTIONS - Math.PI / 4;
        Point2D disc =
            new Point2D.Double(
                at.getX() + far * Math.cos(angle), at.getY() + far * Math.sin(angle));
        if (isRoom(disc, taken)) {
          return disc;
        }
      }
    }
    return nearestFree(at, taken);
  }

  /** The nearest free position in the area, or above its point if there is none. */
  private Point2D nearestFree(Point2D at, List<Point2D> taken) {
    Point2D best = new Point2D.Double(at.getX(), at.getY() - NEAREST);
    double nearest = Double.POSITIVE_INFINITY;
    for (double y = area.getMinY() + TAG; y <= area.getMaxY() - TAG; y += TAG) {
      for (double x = area.getMinX() + TAG; x <= area.getMaxX() - TAG; x += TAG) {
        Point2D disc = new Point2D.Double(x, y);
        if (disc.distance(at) < nearest && isRoom(disc, taken)) {
          nearest = disc.distance(at);
          best = disc;
        }
      }
    }
    return best;
  }

  private boolean isRoom(Point2D disc, List<Point2D> taken) {
    return area.contains(disc.getX() - TAG, disc.getY() - TAG, 2 * TAG, 2 * TAG)
        && taken.stream().allMatch(other -> other.distance(disc) > 2 * TAG + 2)
        && all.stream().allMatch(other -> other.at().distance(disc) > TAG + POINT + 1);
  }
}
