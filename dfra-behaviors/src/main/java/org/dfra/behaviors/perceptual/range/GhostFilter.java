package org.dfra.behaviors.perceptual.range;

import java.time.Duration;
import java.util.ArrayDeque;
import java.util.Arrays;
import java.util.Deque;
import java.util.Iterator;
import java.util.Optional;
import org.dfra.flow.sensor.Odometry;
import org.dfra.flow.sensor.RangeScan;
import org.jspecify.annotations.Nullable;

/**
 * Removes ghosts, which only one or two of the last scans show: it takes the median of each beam
 * over the last scans, each transformed to the robot's current pose. Confined to one thread.
 *
 * <p>An older scan is rotated by the robot's yaw since, to the nearest beam, and its ranges are
 * shortened by the robot's motion along each beam. The motion of other objects is unknown: for an
 * approaching object the median is as old as the middle scan, see {@link #lag}.
 */
final class GhostFilter {

  /** Value of a beam without a measurement; the median ignores it. */
  private static final float UNKNOWN = Float.NaN;

  /** Maximum speed and yaw rate of a robot, metres and radians per second. */
  private static final double FASTEST = 5;

  /** Margin for wheel slip and clock errors between two readings, metres, radians. */
  private static final double SLACK = 0.5;

  private static final Duration MEMORY = Duration.ofSeconds(1); // at least

  private record PastScan(RangeScan scan, double x, double y, double yaw) {}

  private final int depth;
  private final Duration spacing;
  private final Deque<PastScan> past = new ArrayDeque<>(); // the newest first
  private @Nullable Odometry odometry;
  private double lag; // seconds

  /**
   * @param depth number of scans of the median
   * @param spacing minimum time between two of them: a ghost lasts longer than the scan period of a
   *     fast laser
   */
  GhostFilter(int depth, Duration spacing) {
    this.depth = depth;
    this.spacing = spacing;
  }

  /**
   * Adds odometry.
   *
   * @return whether the counts jumped after a reset: earlier scans are then useless
   */
  boolean take(Odometry now) {
    @Nullable Odometry last = odometry;
    boolean isRestarted = last == null || isLeap(last, now);
    if (isRestarted) {
      past.clear();
    }
    odometry = now;
    return isRestarted;
  }

  private static boolean isLeap(Odometry last, Odometry now) {
    double seconds = Math.abs(Duration.between(last.measured(), now.measured()).toNanos() / 1e9);
    double most = SLACK + FASTEST * seconds;
    return Math.hypot(now.x() - last.x(), now.y() - last.y()) > most
        || Math.abs(now.yaw() - last.yaw()) > most;
  }

  /**
   * Adds a scan.
   *
   * @return the median ranges by beam, metres: +∞ without a hit, NaN where most failed; empty
   *     before {@code depth} / 2 + 1 scans were added
   */
  Optional<float[]> take(RangeScan scan) {
    @Nullable Odometry at = odometry;
    PastScan now =
        at == null ? new PastScan(scan, 0, 0, 0) : new PastScan(scan, at.x(), at.y(), at.yaw());
    forgetOthers(now);
    lag = lag(now);
    float[] median = null;
    if (past.size() + 1 > depth / 2) {
      median = median(now);
    }
    @Nullable PastScan newest = past.peekFirst();
    if (newest == null || !scan.measured().isBefore(newest.scan().measured().plus(spacing))) {
      past.addFirst(now);
      if (past.size() >= depth) {
        past.removeLast();
      }
    }
    return Optional.ofNullable(median);
  }

  /**
   * Age relative to the newest scan of the one that determines the range of an approaching object,
   * seconds: the middle one of the last scans, since the newer half shows the object nearer and the
   * older half farther away. It grows where scans are late or lost.
   */
  double lag() {
    return lag;
  }

  private double lag(PastScan now) {
    PastScan deciding = now;
    int older = past.size() / 2; // index of the middle scan
    for (PastScan each : past) {
      if (older == 0) {
        break;
      }
      deciding = each;
      older--;
    }
    return Duration.between(deciding.scan().measured(), now.scan().measured()).toNanos() / 1e9;
  }

  /** Drops scans of another layout, from the future, or too old. */
  private void forgetOthers(PastScan now) {
    Duration span = spacing.multipliedBy(3L * depth);
    Duration oldest = span.compareTo(MEMORY) < 0 ? MEMORY : span;
    for (Iterator<PastScan> all = past.iterator(); all.hasNext(); ) {
      RangeScan scan = all.next().scan();
      Duration age = Duration.between(scan.measured(), now.scan().measured());
      if (scan.beams() != now.scan().beams()
          || scan.firstAngle() != now.scan().firstAngle()
          || scan.angleIncrement() != now.scan().angleIncrement()
          || age.isNegative()
          || age.compareTo(oldest) > 0) {
        all.remove();
      }
    }
  }

  private float[] median(PastScan now) {
    int beams = now.scan().beams();
    float[] result = new float[beams];
    float[] column = new float[past.size() + 1];
    for (int beam = 0; beam < beams; beam++) {
      int known = 0;
      known = add(column, known, now.scan().range(beam));
      for (PastScan each : past) {
        known = add(column, known, seen(each, now, beam));
      }
      if (2 * known <= column.length) {
        result[beam] = UNKNOWN;
      } else {
        Arrays.sort(column, 0, known);
        result[beam] = column[(known - 1) / 2]; // of an even number the nearer one: the safe side
      }
    }
    return result;
  }

  private static int add(float[] column, int known, float range) {
    if (Float.isNaN(range)) {
      return known;
    }
    column[known] = range;
    return known + 1;
  }

  /** Range of an older scan for a beam of the current one. */
  private static float seen(PastScan then, PastScan now, int beam) {
    RangeScan scan = then.scan();
    double turned = now.yaw() - then.yaw();
    int old = beam + (int) Math.rint(turned / scan.angleIncrement());
    if (old < 0 || old >= scan.beams()) {
      return UNKNOWN;
    }
    float range = scan.range(old);
    if (Float.isInfinite(range)) {
      return range;
    }
    double forward =
        Math.cos(then.yaw()) * (now.x() - then.x()) + Math.sin(then.yaw()) * (now.y() - then.y());
    double left =
        Math.cos(then.yaw()) * (now.y() - then.y()) - Math.sin(then.yaw()) * (now.x() - then.x());
    double angle = scan.angle(old);
    double come = forward * Math.cos(angle) + left * Math.sin(angle);
    return (float) Math.max(0, range - come);
  }
}
