package org.dfra.behaviors.perceptual.pose;

import java.time.Instant;
import java.util.Optional;
import org.dfra.flow.sensor.GpsFix;
import org.dfra.geometry.GeoPosition;
import org.dfra.geometry.LocalFrame;
import org.dfra.geometry.LocalPosition;
import org.dfra.geometry.Transform;
import org.dfra.time.ClockOffset;
import org.jspecify.annotations.Nullable;

/**
 * Takes fixes in: leaves out what has no position of its own, comes twice or is nonsense, puts the
 * rest into the local frame and on the robot's clock. A position hold has no position of its own:
 * the receiver was told it.
 */
final class FixPreprocessor {

  /** Receivers told apart. */
  static final int MAX_RECEIVERS = 3;

  /** After this silence a receiver's slot may be given to another. */
  private static final long SILENT = 60 * EpochNanos.SECOND;

  /** Farther from the datum than this nothing is local, metres. */
  private static final double FARTHEST = 1e6;

  /** No antenna is higher or lower than this, metres: beyond it a height is nonsense. */
  private static final double HIGHEST = 1e5;

  /** No lever arm is longer, metres. */
  private static final double LONGEST_ARM = 100;

  /** No receiver here is faster, metres per second. */
  private static final double FASTEST = 500;

  private static final double MOST_DILUTED = 10;

  private final TrackerSettings.GpsErrors errors;
  private final UtcOffsetEstimator offset = new UtcOffsetEstimator();
  private final TimestampMonitor arrivals = new TimestampMonitor();
  private final Receiver[] receivers = new Receiver[MAX_RECEIVERS];
  private @Nullable LocalFrame frame;

  /**
   * @param datum origin of the frame; null for the first position
   */
  FixPreprocessor(TrackerSettings.GpsErrors errors, @Nullable GeoPosition datum) {
    this.errors = errors;
    this.frame = datum == null ? null : new LocalFrame(datum);
  }

  /** The origin; empty before the first position where none was given. */
  Optional<GeoPosition> datum() {
    return Optional.ofNullable(frame).map(LocalFrame::datum);
  }

  /**
   * How far the robot's clock, which shows that time, is ahead of UTC; see {@link
   * UtcOffsetEstimator}.
   */
  Optional<ClockOffset> clockOffset(long now) {
    return offset.estimate(now);
  }

  /** Takes a fix; null where there is nothing to be had from it. */
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

  /** The clock was set or all were silent: any receiver may be replaced. */
  private void loosen(long arrival) {
    for (Receiver receiver : receivers) {
      if (receiver != null) {
        receiver.heard = arrival - SILENT;
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

  /** The slot of a receiver; −1 where all are taken by others that are still heard. */
  private int slot(String source, long arrival) {
    int oldest = 0;
    for (int i = 0; i < MAX_RECEIVERS; i++) {
      if (receivers[i] == null) {
        receivers[i] = new Receiver(source, arrival, false);
        return i;
      }
      if (receivers[i].name.equals(source)) {
        receivers[i].heard = arrival;
        return i;
      }
      if (receivers[i].heard < receivers[oldest].heard) {
        oldest = i;
      }
    }
    if (arrival - receivers[oldest].heard < SILENT) {
      return -1;
    }
    receivers[oldest] = new Receiver(source, arrival, true);
    return oldest;
  }

  /** A receiver and the moments of its last fixes. */
  private static final class Receiver {

    private static final int KEPT = 8;

    final String name;
    long heard;
    boolean isNew;
    private final long[] moments = new long[KEPT];
    private int count;

    Receiver(String name, long received, boolean isNew) {
      this.name = name;
      this.heard = received;
      this.isNew = isNew;
    }

    /** Whether the fix of that moment was here before; remembers it. */
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
