package org.dfra.report.plot;

import java.util.Arrays;

/**
 * Points of one series, and their style. Series of one name have one colour and one entry in the
 * legend; those without a name are grey and have none. A point with a coordinate that is not finite
 * is omitted, and interrupts the line.
 */
public final class Series {

  private static final int CORNERS = 48;

  private final String name;
  private final Style style;
  private final double[] x;
  private final double[] y;
  private final boolean isFaint;

  /** Style of the points. */
  enum Style {
    /** Joined by straight lines. */
    LINE,
    /** Joined by a line that stays level up to the next point. */
    STEPS,
    /** Separate points. */
    POINTS,
    /** As the corners of a filled polygon. */
    AREA
  }

  private Series(String name, Style style, double[] x, double[] y) {
    this(name, style, x, y, false);
  }

  private Series(String name, Style style, double[] x, double[] y, boolean isFaint) {
    if (x.length != y.length) {
      throw new IllegalArgumentException(
          "the series " + name + " has " + x.length + " x and " + y.length + " y");
    }
    this.name = name;
    this.style = style;
    this.isFaint = isFaint;
    this.x = x.clone();
    this.y = y.clone();
    for (int i = 0; i < x.length; i++) {
      if (!Double.isFinite(x[i]) || !Double.isFinite(y[i])) {
        this.x[i] = i == 0 ? 0 : this.x[i - 1]; // only y marks a missing point
        this.y[i] = Double.NaN;
      }
    }
  }

  /** Points joined by straight lines. */
  public static Series line(String name, double[] x, double[] y) {
    return new Series(name, Style.LINE, x, y);
  }

  /** Values that hold until the next one: a state, a command. */
  public static Series steps(String name, double[] x, double[] y) {
    return new Series(name, Style.STEPS, x, y);
  }

  /** Separate points: fixes, waypoints. */
  public static Series points(String name, double[] x, double[] y) {
    return new Series(name, Style.POINTS, x, y);
  }

  /** A filled polygon by its corners: a field, an obstacle. */
  public static Series area(String name, double[] x, double[] y) {
    return new Series(name, Style.AREA, closed(x), closed(y));
  }

  /** A filled circle, in the units of equal axes. */
  public static Series circle(String name, double x, double y, double radius) {
    double[] xs = new double[CORNERS];
    double[] ys = new double[CORNERS];
    for (int i = 0; i < CORNERS; i++) {
      double angle = 2 * Math.PI * i / CORNERS;
      xs[i] = x + radius * Math.cos(angle);
      ys[i] = y + radius * Math.sin(angle);
    }
    return area(name, xs, ys);
  }

  /** The same, pale, for the background: raw data, a plan. */
  public Series faint() {
    return new Series(name, style, x, y, true);
  }

  private static double[] closed(double[] corners) {
    double[] closed = Arrays.copyOf(corners, corners.length == 0 ? 0 : corners.length + 1);
    if (closed.length > 0) {
      closed[corners.length] = corners[0];
    }
    return closed;
  }

  /** Its name in the legend. */
  public String name() {
    return name;
  }

  Style style() {
    return style;
  }

  boolean isFaint() {
    return isFaint;
  }

  double[] x() {
    return x.clone();
  }

  double[] y() {
    return y.clone();
  }

  /** Whether there is anything to draw. */
  boolean isEmpty() {
    return Arrays.stream(y).noneMatch(Double::isFinite);
  }
}
