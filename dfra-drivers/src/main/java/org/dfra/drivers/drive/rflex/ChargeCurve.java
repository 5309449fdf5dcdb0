package org.dfra.drivers.drive.rflex;

import java.math.BigDecimal;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;

/**
 * The remaining charge of a battery as a function of its voltage, linear between points. Its text
 * form is {@code volts:share volts:share ...}, both rising, the shares from 0 to 1.
 *
 * @param points at least two
 */
record ChargeCurve(List<Point> points) {

  /**
   * A point of the curve.
   *
   * @param voltage volts
   * @param remaining charge left, 0 is empty, 1 is full
   */
  record Point(double voltage, double remaining) {

    @Override
    public String toString() {
      return plain(voltage) + ":" + plain(remaining);
    }
  }

  /** Two sealed 12 V lead-acid batteries in series, without load: empty at 11.8 V each. */
  static final ChargeCurve LEAD_ACID_24 = parse("23.6:0 24.2:0.25 24.7:0.5 25.2:0.75 25.7:1");

  private static final String FORM =
      "a curve like \"23.6:0 24.7:0.5 25.7:1\", volts and shares rising, shares from 0 to 1";

  ChargeCurve {
    points = List.copyOf(points);
  }

  /**
   * Parses a curve.
   *
   * @throws IllegalArgumentException if the text is invalid; the message completes a sentence
   */
  static ChargeCurve parse(String text) {
    List<Point> points = new ArrayList<>();
    for (String each : text.strip().split("\\s+", -1)) {
      Point point = point(each);
      Point last = points.isEmpty() ? null : points.get(points.size() - 1);
      if (point.remaining() < 0
          || point.remaining() > 1
          || (last != null
              && (point.voltage() <= last.voltage() || point.remaining() < last.remaining()))) {
        throw new IllegalArgumentException(FORM);
      }
      points.add(point);
    }
    if (points.size() < 2) {
      throw new IllegalArgumentException(FORM);
    }
    return new ChargeCurve(points);
  }

  private static Point point(String text) {
    String[] parts = text.split(":", -1);
    if (parts.length == 2) {
      try {
        return new Point(
            new BigDecimal(parts[0]).doubleValue(), new BigDecimal(parts[1]).doubleValue());
      } catch (NumberFormatException e) {
        throw new IllegalArgumentException(FORM, e);
      }
    }
    throw new IllegalArgumentException(FORM);
  }

  /** The remaining charge at a voltage; outside the curve, that of the nearer end. */
  double remaining(double voltage) {
    Point below = points.get(0);
    for (Point above : points) {
      if (voltage < above.voltage()) {
        double share =
            above == below ? 0 : (voltage - below.voltage()) / (above.voltage() - below.voltage());
        return below.remaining() + share * (above.remaining() - below.remaining());
      }
      below = above;
    }
    return below.remaining();
  }

  private static String plain(double number) {
    return BigDecimal.valueOf(number).stripTrailingZeros().toPlainString();
  }

  /** The text form that {@link #parse} reads. */
  @Override
  public String toString() {
    return points.stream().map(Point::toString).collect(Collectors.joining(" "));
  }
}
