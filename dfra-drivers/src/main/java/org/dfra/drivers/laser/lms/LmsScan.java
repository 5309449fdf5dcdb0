package org.dfra.drivers.laser.lms;

import java.util.Arrays;
import org.dfra.drivers.laser.lms.LmsConfiguration.LmsUnit;

/**
 * {@code B0}: a scan, its samples from right to left. The distance bits of a sample depend on the
 * laser's measuring mode, which a scan does not contain.
 *
 * @param unit unit of distance
 * @param samples 0 to 65 535 each; copied in and out
 * @param index the laser's counter of scans, 0 to 255; −1 where it does not send one
 * @param status the laser's status
 */
public record LmsScan(
    LmsUnit unit,
    @SuppressWarnings("ArrayRecordComponent") int[] samples,
    int index,
    StatusByte status)
    implements LmsMessage.Telegram {

  public LmsScan {
    samples = samples.clone();
  }

  @Override
  public String name() {
    return "B0";
  }

  @Override
  public int[] samples() {
    return samples.clone();
  }

  /** Number of beams. */
  public int beams() {
    return samples.length;
  }

  /** Distances in metres, or special values; see {@link MeasuringMode#range}. */
  public float[] ranges(MeasuringMode mode) {
    float[] ranges = new float[samples.length];
    for (int i = 0; i < ranges.length; i++) {
      ranges[i] = mode.range(samples[i], unit);
    }
    return ranges;
  }

  @Override
  public boolean equals(Object other) {
    return other instanceof LmsScan that
        && unit == that.unit
        && index == that.index
        && status.equals(that.status)
        && Arrays.equals(samples, that.samples);
  }

  @Override
  public int hashCode() {
    return 31 * Arrays.hashCode(samples) + index;
  }

  /** One line, with the number of samples instead of the samples. */
  @Override
  public String toString() {
    return "LmsScan[" + samples.length + " beams in " + unit + ", index=" + index + ", " + status;
  }
}
