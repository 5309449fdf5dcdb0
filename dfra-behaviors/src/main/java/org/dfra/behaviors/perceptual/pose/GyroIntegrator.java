package org.dfra.behaviors.perceptual.pose;

import org.dfra.flow.sensor.AngularRate;

/**
 * Integrates a gyro's rates by the trapezoidal rule. A gap of more than 0.3 s starts a new segment:
 * angles before and after it are not comparable.
 */
final class GyroIntegrator {

  /** For how long a rate is extrapolated. */
  private static final long HOLD = 3 * EpochNanos.SECOND / 10;

  /** Five seconds at 100 Hz. */
  private static final int KEPT = 512;

  /** Maximum rate of a gyro, radians per second. */
  private static final double FASTEST = 30;

  private final TimestampMonitor continuity = new TimestampMonitor();
  private final long[] times = new long[KEPT];
  private final double[] angles = new double[KEPT];
  private double lastRate;
  private long count;
  private int stretch;

  void take(AngularRate rate) {
    if (!(Math.abs(rate.rate()) < FASTEST) || !EpochNanos.isPlausible(rate.measured())) {
      return;
    }
    long time = EpochNanos.of(rate.measured());
    switch (continuity.classify(time)) {
      case OUT_OF_ORDER, SUSPECT -> {}
      case FIRST, JUMP -> begin(time, rate.rate());
      case NEXT -> {
        int last = (int) ((count - 1) % KEPT);
        double dt = EpochNanos.seconds(times[last], time);
        if (time - times[last] > HOLD) {
          begin(time, rate.rate());
        } else {
          put(time, angles[last] + (lastRate + rate.rate()) / 2 * dt, rate.rate());
        }
      }
    }
  }

  private void begin(long time, double rate) {
    count = 0;
    stretch++;
    put(time, 0, rate);
  }

  private void put(long time, double angle, double rate) {
    int at = (int) (count % KEPT);
    times[at] = time;
    angles[at] = angle;
    lastRate = rate;
    count++;
  }

  /** Number of the current segment: angles of different segments are not comparable. */
  int segment() {
    return stretch;
  }

  /** The last rate, radians per second, bias included; 0 before the first. */
  double rate() {
    return lastRate;
  }

  /**
   * The angle in this segment, radians; NaN where it is unknown.
   *
   * @param time shortly after the last rate at most, which is then extrapolated
   */
  double angleAt(long time) {
    if (count == 0) {
      return Double.NaN;
    }
    int last = (int) ((count - 1) % KEPT);
    if (time >= times[last]) {
      return time - times[last] > HOLD
          ? Double.NaN
          : angles[last] + lastRate * EpochNanos.seconds(times[last], time);
    }
    long oldest = Math.max(0, count - KEPT);
    for (long i = count - 2; i >= oldest; i--) {
      int at = (int) (i % KEPT);
      if (times[at] <= time) {
        int next = (int) ((i + 1) % KEPT);
        double part =
            EpochNanos.seconds(times[at], time) / EpochNanos.seconds(times[at], times[next]);
        return angles[at] + part * (angles[next] - angles[at]);
      }
    }
    return Double.NaN;
  }
}
