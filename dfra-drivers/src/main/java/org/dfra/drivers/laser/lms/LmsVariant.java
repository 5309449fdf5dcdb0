package org.dfra.drivers.laser.lms;

import java.util.List;
import java.util.Optional;

/**
 * Where the laser's beams are. They turn from right to left, the middle one is forward. The mirror
 * turns {@value #REVOLUTIONS_PER_SECOND} times in a second and meets beams a degree apart; finer
 * ones take several turns, each a little further than the last.
 *
 * @param fieldDegrees from the first beam to the last, 100 or 180
 * @param stepHundredths from beam to beam, hundredths of a degree: 25, 50 or 100
 */
public record LmsVariant(int fieldDegrees, int stepHundredths) {

  static final int REVOLUTIONS_PER_SECOND = 75;

  /** Those that there are, of which 0.25° needs the narrow field. */
  private static final List<LmsVariant> ALL =
      List.of(
          new LmsVariant(180, 100),
          new LmsVariant(180, 50),
          new LmsVariant(100, 100),
          new LmsVariant(100, 50),
          new LmsVariant(100, 25));

  /** The variant, if there is such a one. */
  static Optional<LmsVariant> of(int degrees, int hundredths) {
    LmsVariant asked = new LmsVariant(degrees, hundredths);
    return ALL.contains(asked) ? Optional.of(asked) : Optional.empty();
  }

  /** How many beams. */
  public int beams() {
    return fieldDegrees * 100 / stepHundredths + 1;
  }

  /** Angle of the first beam, radians, 0 is forward, to the left is +. */
  public double firstAngle() {
    return -Math.toRadians(fieldDegrees / 2.0);
  }

  /** From one beam to the next, radians, to the left. */
  public double step() {
    return Math.toRadians(stepHundredths / 100.0);
  }

  /** From the first beam to the last, radians. */
  public double fieldOfView() {
    return Math.toRadians(fieldDegrees);
  }

  /** Turns of the mirror for one scan. */
  private int revolutions() {
    return 100 / stepHundredths;
  }

  /** Seconds from one scan to the next, where the line is fast enough. */
  public double period() {
    return (double) revolutions() / REVOLUTIONS_PER_SECOND;
  }

  /** Seconds from the first beam measured to the last: all turns but the rest of the last one. */
  public double duration() {
    return (revolutions() - 1 + fieldDegrees / 360.0) / REVOLUTIONS_PER_SECOND;
  }

  /** Bytes of a scan's telegram. */
  public int telegramBytes() {
    return LmsFramer.HEAD + 3 + 2 * beams() + 1 + LmsFramer.TAIL;
  }

  /**
   * Scans in a second over a line.
   *
   * @param baud its bits per second
   */
  public double rate(int baud) {
    return Math.min(1 / period(), baud / 10.0 / telegramBytes());
  }

  /** {@code 180° by 0.5°}. */
  public String inWords() {
    String step = stepHundredths == 100 ? "1" : stepHundredths == 50 ? "0.5" : "0.25";
    return fieldDegrees + "° by " + step + "°";
  }
}
