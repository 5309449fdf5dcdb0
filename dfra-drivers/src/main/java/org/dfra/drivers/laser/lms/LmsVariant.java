package org.dfra.drivers.laser.lms;

import java.util.List;
import java.util.Optional;
import org.dfra.drivers.laser.lms.LmsParser.LmsFramer;

/**
 * Field of view and resolution of the laser's beams. They sweep from right to left, the middle beam
 * points forward. The mirror makes {@value #REVOLUTIONS_PER_SECOND} revolutions per second with
 * beams one degree apart; finer resolutions take several revolutions, each with a small offset.
 *
 * @param fieldDegrees from the first beam to the last, 100 or 180
 * @param stepHundredths from beam to beam, hundredths of a degree: 25, 50 or 100
 */
public record LmsVariant(int fieldDegrees, int stepHundredths) {

  static final int REVOLUTIONS_PER_SECOND = 75;

  /** The supported variants; 0.25° requires the narrow field. */
  private static final List<LmsVariant> ALL =
      List.of(
          new LmsVariant(180, 100),
          new LmsVariant(180, 50),
          new LmsVariant(100, 100),
          new LmsVariant(100, 50),
          new LmsVariant(100, 25));

  /** The variant with these values, if it is supported. */
  static Optional<LmsVariant> of(int degrees, int hundredths) {
    LmsVariant asked = new LmsVariant(degrees, hundredths);
    return ALL.contains(asked) ? Optional.of(asked) : Optional.empty();
  }

  /** Number of beams. */
  public int beams() {
    return fieldDegrees * 100 / stepHundredths + 1;
  }

  /** Angle of the first beam, radians, 0 is forward, to the left is +. */
  public double firstAngle() {
    return -Math.toRadians(fieldDegrees / 2.0);
  }

  /** Angle from one beam to the next, radians, to the left. */
  public double step() {
    return Math.toRadians(stepHundredths / 100.0);
  }

  /** Angle from the first beam to the last, radians. */
  public double fieldOfView() {
    return Math.toRadians(fieldDegrees);
  }

  /** Revolutions of the mirror for one scan. */
  private int revolutions() {
    return 100 / stepHundredths;
  }

  /** Seconds from one scan to the next, where the link is fast enough. */
  public double period() {
    return (double) revolutions() / REVOLUTIONS_PER_SECOND;
  }

  /**
   * Seconds from the first measured beam to the last: all revolutions without the remainder of the
   * last.
   */
  public double duration() {
    return (revolutions() - 1 + fieldDegrees / 360.0) / REVOLUTIONS_PER_SECOND;
  }

  /** Bytes of a scan's telegram. */
  public int telegramBytes() {
    return LmsFramer.HEAD + 3 + 2 * beams() + 1 + LmsFramer.TAIL;
  }

  /**
   * Scans per second over a link.
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
