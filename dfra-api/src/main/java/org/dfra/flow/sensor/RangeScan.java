package org.dfra.flow.sensor;

import java.io.Serial;
import java.time.Instant;
import java.util.Arrays;
import org.dfra.event.Reading;

/**
 * Distances along beams that lie in the plane x-y of the sensor's frame and begin at its origin,
 * with REP-117's values for invalid ranges.
 *
 * @param measured time of the first beam, UTC
 * @param frame name of the sensor's frame, e.g. {@code atrv1/laser}
 * @param firstAngle angle of the first beam in radians, 0 is forward, to the left is +
 * @param angleIncrement from one beam to the next in radians; counter-clockwise is +, not 0
 * @param duration seconds from the first beam to the last, not negative
 * @param minRange minimum measurable distance, metres
 * @param maxRange maximum measurable distance, metres
 * @param ranges the distances in metres, single precision; +∞ if a beam met nothing, −∞ if
 *     something was too close to be measured, NaN if the measurement failed. Copied in and out.
 */
public record RangeScan(
    Instant measured,
    String frame,
    double firstAngle,
    double angleIncrement,
    double duration,
    double minRange,
    double maxRange,
    @SuppressWarnings("ArrayRecordComponent") float[] ranges)
    implements Reading {

  public RangeScan {
    if (frame.isBlank()) {
      throw new IllegalArgumentException("a scan names no frame");
    }
    if (!(Double.isFinite(firstAngle) && Double.isFinite(angleIncrement) && angleIncrement != 0)) {
      throw new IllegalArgumentException(
          "beams from " + firstAngle + " rad by " + angleIncrement + " rad are no scan");
    }
    if (!(duration >= 0 && minRange >= 0 && minRange < maxRange && Double.isFinite(maxRange))) {
      throw new IllegalArgumentException(
          "a scan of " + duration + " s from " + minRange + " m to " + maxRange + " m");
    }
    ranges = ranges.clone();
  }

  @Override
  public float[] ranges() {
    return ranges.clone();
  }

  /** The number of beams. */
  public int beams() {
    return ranges.length;
  }

  /** Distance along a beam, metres, or the value for an invalid range. */
  public float range(int beam) {
    return ranges[beam];
  }

  /** Angle of a beam in radians, 0 is forward, to the left is +. */
  public double angle(int beam) {
    return firstAngle + beam * angleIncrement;
  }

  /** Whether the beam has a measured distance. */
  public boolean isMeasured(int beam) {
    return Float.isFinite(ranges[beam]);
  }

  @Override
  public boolean equals(Object other) {
    return other instanceof RangeScan that
        && measured.equals(that.measured)
        && frame.equals(that.frame)
        && firstAngle == that.firstAngle
        && angleIncrement == that.angleIncrement
        && duration == that.duration
        && minRange == that.minRange
        && maxRange == that.maxRange
        && Arrays.equals(ranges, that.ranges);
  }

  @Override
  public int hashCode() {
    return 31 * measured.hashCode() + Arrays.hashCode(ranges);
  }

  /** One line with the number of beams instead of the ranges. */
  @Override
  public String toString() {
    int met = 0;
    float nearest = Float.POSITIVE_INFINITY;
    for (float range : ranges) {
      if (Float.isFinite(range)) {
        met++;
        nearest = Math.min(nearest, range);
      }
    }
    return "RangeScan[measured="
        + measured
        + ", frame="
        + frame
        + ", beams="
        + ranges.length
        + ", measuredBeams="
        + met
        + (met == 0 ? "]" : ", nearest=" + nearest + " m]");
  }

  @Serial
  private Object writeReplace() {
    return SensorForm.of(this);
  }
}
