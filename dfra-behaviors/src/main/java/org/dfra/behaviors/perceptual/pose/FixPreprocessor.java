package org.dfra.behaviors.perceptual.pose;

import java.time.Instant;
import java.util.Optional;
import org.dfra.behaviors.perceptual.pose.FilterInput.LocalFix;
import org.dfra.flow.sensor.GpsFix;
import org.dfra.geometry.GeoPosition;
import org.dfra.geometry.LocalFrame;
import org.dfra.geometry.LocalPosition;
import org.dfra.geometry.Transform;
import org.dfra.time.ClockOffset;
import org.jspecify.annotations.Nullable;

/**
 * Preprocesses fixes: drops those without a measured position, duplicates and implausible values,
 * and converts the others to the local frame and the robot's clock. In position hold the position
 * is not measured: it was set by a command.
 */
final class FixPreprocessor {

  /** Maximum number of receivers. */
  static final int MAX_RECEIVERS = 3;

  /** After this time without a fix a receiver's slot may be reused. */
  private static final long SILENT = 60 * EpochNanos.SECOND;

  /** Maximum distance from the datum, metres. */
  private static final double FARTHEST = 1e6;

  /** Limit of antenna heights, metres: beyond it a height is implausible. */
  private static final double HIGHEST = 1e5;

  /** Maximum lever arm, metres. */
  private static final double LONGEST_ARM = 100;

  /** Maximum speed of a receiver, metres per second. */
  private static final double FASTEST = 500;

  private static final double MOST_DILUTED = 10;

  private final TrackerSettings.GpsErrors errors;
  private final UtcOffsetEstimator offset = new UtcOffsetEstimator();
  private final TimestampMonitor arrivals = new TimestampMonitor();
  private final Receiver[] receivers = new Receiver[MAX_RECEIVERS];
  private @Nullable LocalFrame frame;

  /**
   * @param datum origin of the frame; null to use the first position
   */
  FixPreprocessor(TrackerSettings.GpsErrors errors, @Nullable GeoPosition datum) {
    this.errors = errors;
    this.frame = datum == null ? null : new LocalFrame(datum);
  }

  /** The origin; empty before the first position where none was given. */
  Optional<GeoPosition> datum() {
    return Optional.ofNullable(frame).map(LocalFrame::datum);
  }

  /** Offset of the robot's clock, at that time, ahead of UTC; see {@link UtcOffsetEstimator}. */
  Optional<ClockOffset> clockOffset(long now) {
    return offset.estimate(now);
  }

  /** Converts a fix; null where it is unusable. */
  @Nullable LocalFix process(GpsFix fix, String source, Transform antenna, Instant received) {
    if (fix.mode() == GpsFix.Mode.NONE
        || !EpochNanos.isPlausible(fix.utc())
        || !EpochNanos.isPlausible(received)) {
      return null;
    }
    long arrival = EpochNanos.of(received);
    TimestampMonitor.Classification verdict = arrivals.classify(arrival);
    if (verdict == TimestampMonitor.Classification.SUSPECT) {
      return null;
    }
    if (verdict == TimestampMonitor.Classification.JUMP) {
      offset.clear();
      loosen(arrival);
    }
    long utc = EpochNanos.of(fix.utc());
    int slot = slot(source, arrival);
    if (slot < 0 || receivers[slot].isRepeated(utc)) {
      return null;
    }
    offset.addFix(utc, arrival);
    GeoPosition position = fix.position();
    if (fix.mode() == GpsFix.Mode.POSITION_HOLD
        || position == null
        || !(Math.abs(position.height()) < HIGHEST)
        || !(Math.hypot(antenna.x(), antenna.y()) < LONGEST_ARM)) {
      return null;
    }
    return local(fix, position, antenna, slot, utc);
  }

  /** The clock was set or no receiver sent fixes: any slot may be reused. */
  private void loosen(long arrival) {
    for (Receiver receiver : receivers) {
      if (receiver != null) {
        receiver.lastReceived = arrival - SILENT;
      }
    }
  }

  private @Nullable LocalFix local(
      GpsFix fix, GeoPosition position, Transform antenna, int slot, long utc) {
    LocalFrame to = frame;
    if (to == null) {
      to = new LocalFrame(position);
      frame = to;
    }
    LocalPosition at = to.toLocal(position);
    if (!(Math.hypot(at.east(), at.north()) < FARTHEST)) {
      return null;
    }
    boolean isNew = receivers[slot].isNew;
    receivers[slot].isNew = false;
    double diluted =
        Math.max(1, Math.min(MOST_DILUTED, fix.dilutionOfPrecision() / errors.referenceDilution()));
    boolean hasCourse = fix.speed() >= errors.minCourseSpeed() && fix.speed() < FASTEST;
    return new LocalFix(
        utc + offset.offsetNanos() - EpochNanos.of(errors.minLatency()),
        slot,
        isNew,
        at.east(),
        at.north(),
        antenna.x(),
        antenna.y(),
        errors.whiteNoiseSigma() * (Double.isNaN(diluted) ? 1 : diluted),
        Double.isNaN(fix.speed()) ? 0 : Math.min(fix.speed(), FASTEST),
        hasCourse ? Math.toRadians(90 - fix.course()) : Double.NaN);
  }

  /** The slot of a receiver; −1 where all are in use by other active receivers. */
  private int slot(String source, long arrival) {
    int oldest = 0;
    for (int i = 0; i < MAX_RECEIVERS; i++) {
      if (receivers[i] == null) {
        receivers[i] = new Receiver(source, arrival, false);
        return i;
      }
      if (receivers[i].name.equals(source)) {
        receivers[i].lastReceived = arrival;
        return i;
      }
      if (receivers[i].lastReceived < receivers[oldest].lastReceived) {
        oldest = i;
      }
    }
    if (arrival - receivers[oldest].lastReceived < SILENT) {
      return -1;
    }
    receivers[oldest] = new Receiver(source, arrival, true);
    return oldest;
  }

  /** A receiver and the times of its last fixes. */
  private static final class Receiver {

    private static final int KEPT = 8;

    final String name;
    long lastReceived;
    boolean isNew;
    private final long[] moments = new long[KEPT];
    private int count;

    Receiver(String name, long received, boolean isNew) {
      this.name = name;
      this.lastReceived = received;
      this.isNew = isNew;
    }

    /** Whether a fix of that time was received before; stores it. */
    boolean isRepeated(long utc) {
      for (int i = 0; i < Math.min(count, KEPT); i++) {
        if (moments[i] == utc) {
          return true;
        }
      }
      moments[count % KEPT] = utc;
      count = count + 1 == 2 * KEPT ? KEPT : count + 1; // stays above KEPT once it is full
      return false;
    }
  }
}
