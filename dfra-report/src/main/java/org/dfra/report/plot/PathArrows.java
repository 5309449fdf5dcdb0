package org.dfra.report.plot;

import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import java.awt.geom.Point2D;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.List;

/** Shows the direction of a path: a ring at its start, a square at its end, arrows. */
final class PathArrows {

  private static final double START = 5; // radius, pixels
  private static final double END = 4.5; // half a side
  private static final double EVERY = 110; // pixels along the path
  private static final double CHORD = 6; // pixels, over which an arrow's direction is measured
  private static final double LENGTH = 10;
  private static final double HALF_WIDTH = 4.5;

  /** An arrow's tip and direction, radians, clockwise from the right. */
  record Arrow(Point2D at, double angle) {}

  private PathArrows() {}

  static void paint(Graphics2D g, Plot plot, Series way, Color colour) {
    List<Point2D> points = points(plot, way);
    if (points.isEmpty()) {
      return;
    }
    g.setColor(colour);
    arrows(points).forEach(each -> g.fill(shape(each)));
    if (length(points) > 2 * START) {
      paintEnd(g, points.get(points.size() - 1), colour);
    }
    paintStart(g, points.get(0), colour);
  }

  /**
   * The legend's entry for paths: start, direction and end.
   *
   * @param left its left end, in pixels, like all parameters
   * @param right its right end
   * @param y its height
   */
  static void paintKey(Graphics2D g, double left, double right, double y) {
    g.setColor(Palette.GREY);
    g.setStroke(Palette.stroke(0));
    g.draw(new Line2D.Double(left, y, right, y));
    g.fill(shape(new Arrow(new Point2D.Double((left + right) / 2, y), 0)));
    paintEnd(g, new Point2D.Double(right, y), Palette.GREY);
    paintStart(g, new Point2D.Double(left, y), Palette.GREY);
  }

  private static void paintEnd(Graphics2D g, Point2D end, Color colour) {
    g.setColor(colour);
    g.setStroke(Palette.THIN);
    g.fill(new Rectangle2D.Double(end.getX() - END, end.getY() - END, 2 * END, 2 * END));
  }

  private static void paintStart(Graphics2D g, Point2D start, Color colour) {
    Ellipse2D ring =
        new Ellipse2D.Double(start.getX() - START, start.getY() - START, 2 * START, 2 * START);
    g.setColor(Palette.PAPER);
    g.fill(ring);
    g.setColor(colour);
    g.setStroke(Palette.stroke(0));
    g.draw(ring);
  }

  private static List<Point2D> points(Plot plot, Series way) {
    double[] x = way.x();
    double[] y = way.y();
    List<Point2D> points = new ArrayList<>();
    for (int i = 0; i < x.length; i++) {
      if (Double.isFinite(y[i])) {
        points.add(new Point2D.Double(plot.x(x[i]), plot.y(y[i])));
      }
    }
    return points;
  }

  private static double length(List<Point2D> points) {
    double length = 0;
    for (int i = 1; i < points.size(); i++) {
      length += points.get(i).distance(points.get(i - 1));
    }
    return length;
  }

  /**
   * Evenly spaced along the path; one in the middle of a short path, none if the robot did not
   * move.
   */
  static List<Arrow> arrows(List<Point2D> points) {
    double length = length(points);
    if (length < 4 * LENGTH) {
      return List.of();
    }
    int number = Math.max(1, (int) (length / EVERY));
    List<Arrow> arrows = new ArrayList<>();
    double gone = 0;
    double next = length / number / 2;
    Point2D behind = points.get(0);
    for (int i = 1; i < points.size(); i++) {
      Point2D here = points.get(i);
      gone += here.distance(points.get(i - 1));
      if (gone >= next && here.distance(behind) >= CHORD) {
        double angle = Math.atan2(here.getY() - behind.getY(), here.getX() - behind.getX());
        arrows.add(new Arrow(here, angle));
        next += length / number;
      }
      if (here.distance(behind) >= CHORD) {
        behind = here;
      }
    }
    return arrows;
  }

  private static Path2D shape(Arrow arrow) {
    double cos = Math.cos(arrow.angle());
    double sin = Math.sin(arrow.angle());
    double x = arrow.at().getX();
    double y = arrow.at().getY();
    Path2D shape = new Path2D.Double();
    shape.moveTo(x + cos * LENGTH / 2, y + sin * LENGTH / 2);
    shape.lineTo(x - cos * LENGTH / 2 - sin * HALF_WIDTH, y - sin * LENGTH / 2 + cos * HALF_WIDTH);
    shape.lineTo(x - cos * LENGTH / 2 + sin * HALF_WIDTH, y - sin * LENGTH / 2 - cos * HALF_WIDTH);
    shape.closePath();
    return shape;
  }
}
