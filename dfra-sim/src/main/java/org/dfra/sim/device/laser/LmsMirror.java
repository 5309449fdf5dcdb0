package org.dfra.sim.device.laser;

import java.time.Duration;
import java.time.Instant;
import org.dfra.sim.physics.RangeInput;
import org.jspecify.annotations.Nullable;

/** The laser's rotating mirror: its scans, and when each is complete. Confined to one thread. */
final class LmsMirror {

  static final double REVOLUTIONS_PER_SECOND = 75;

  private static final double FARTHEST = 80; // metres
  private static final int RESERVED = 8;
  private static final int WIDEST = 180;
  private static final int NARROW = 100;
  private static final double[] METRES = {0.01, 0.001};

  private final RangeInput view;
  private int degrees;
  private int hundredths;
  private Instant streamBegin = Instant.EPOCH;
  private long sentScans; // of the stream, including skipped ones

  LmsMirror(RangeInput view) {
    this.view = view;
    reset();
  }

  /** The state after power-on. */
  void reset() {
    degrees = WIDEST;
    hundredths = 50;
  }

  int degrees() {
    return degrees;
  }

  int hundredths() {
    return hundredths;
  }

  /** Changes the beam layout; false where that is invalid. */
  boolean setVariant(int field, int step) {
    boolean exists =
        (field == NARROW || field == WIDEST)
            && (step == 100 || step == 50 || (step == 25 && field == NARROW));
    degrees = exists ? field : degrees;
    hundredths = exists ? step : hundredths;
    return exists;
  }

  /** Whether it supports this unit. */
  static boolean isKnownUnit(int unit) {
    return unit >= 0 && unit < METRES.length;
  }

  void beginStream(Instant now) {
    streamBegin = now;
    sentScans = 0;
  }

  /** Start of the last scan of the stream that is complete and unsent; null for none. */
  @Nullable Instant complete(Instant now) {
    long nanos = periodNanos();
    long complete = Math.max(0, Duration.between(streamBegin, now).toNanos() / nanos);
    if (complete <= sentScans) {
      return null;
    }
    sentScans = complete;
    return streamBegin.plusNanos((complete - 1) * nanos);
  }

  /** Nanoseconds for a scan. */
  long periodNanos() {
    return Math.round(1e9 * (100.0 / hundredths) / REVOLUTIONS_PER_SECOND);
  }

  /**
   * The scan that starts at that time, samples from right to left.
   *
   * @param unit 0 cm, 1 mm
   * @param mode its measuring mode
   */
  int[] samples(Instant begin, int unit, int mode) {
    double metres = METRES[unit];
    int top = (1 << bits(mode)) - 1;
    double longest = Math.min(FARTHEST, (top - RESERVED - 1) * metres);
    double[] distances = new double[degrees * 100 / hundredths + 1];
    double first = -Math.toRadians(degrees / 2.0);
    view.measure(begin, first, Math.toRadians(hundredths / 100.0), longest, distances);
    int[] samples = new int[distances.length];
    for (int i = 0; i < samples.length; i++) {
      if (Double.isNaN(distances[i])) {
        samples[i] = top;
      } else {
        samples[i] =
            distances[i] > longest ? top - RESERVED : (int) Math.round(distances[i] / metres);
      }
    }
    return samples;
  }

  private static int bits(int mode) {
    return switch (mode) {
      case 0, 1, 2 -> 13;
      case 3, 4 -> 14;
      case 5, 6 -> 15;
      default -> 16;
    };
  }
}
