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
 * Takes out of a scan what only one or two of the last scans show: the median of each beam over the
 * last scans, each moved to where the robot is now. Confined to one thread.
 *
 * <p>An older scan is turned by how far the robot has turned since, to the nearest beam, and its
 * ranges are shortened by how far the robot has come along each beam. How far something else has
 * come by itself is not known: of what comes nearer the median is as old as the scan in the middle,
 * see {@link #lag}.
 */
final class GhostFilter {

  /** What a beam has that measured nothing; it does not count in the median. */
  private static final float UNKNOWN = Float.NaN;

  /** No robot goes or turns faster than this, metres and radians per second. */
  private static final double FASTEST = 5;

  /** What wheels may slip and clocks be off by from one count to the next, metres, radians. */
  private static final double SLACK = 0.5;

  private static final Duration MEMORY = Duration.ofSeconds(1); // at least

  private record PastScan(RangeScan scan, double x, double y, double yaw) {}

  private final int depth;
  private final Duration spacing;
  private final Deque<PastScan> past = new ArrayDeque<>(); // the newest first
  private @Nullable Odometry odometry;
  private double lag; // seconds

  /**
   * @param depth scans that the median is of
   * @param spacing time from one of them to the next, at least: a ghost lasts longer than the time
   *     between two scans of a fast laser
   */
  GhostFilter(int depth, Duration spacing) {
    this.depth = depth;
    this.spacing = spacing;
  }

  /**
   * Takes where the wheels are.
   *
   * @return whether that leapt, counted anew: then what was seen before says nothing more
   */
  boolean take(Odometry now) {
    @Nullable Odometry last = odometry;
    boolean isAnew = last == null || isLeap(last, now);
    if (isAnew) {
      past.clear();
    }
    odometry = now;
    return isAnew;
  }

  private static boolean isLeap(Odometry last, Odometry now) {
    double seconds = Math.abs(Duration.between(last.measured(), now.measured()).toNanos() / 1e9);
    double most = SLACK + FASTEST * seconds;
    return Math.hypot(now.x() - last.x(), now.y() - last.y()) > most
        || Math.abs(now.yaw() - last.yaw()) > most;
  }

  /**
   * Takes a scan.
   *
   * @return the median ranges by beam, metres: +∞ where nothing was met, NaN where more failed than
   *     not; nothing before {@code depth} / 2 + 1 scans were seen
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
   * By how much the scan that decides about what comes nearer by itself is older than the newest
   * one, seconds: that in the middle of the last scans, since the newer half shows it nearer and
   * the older half farther away. It grows where scans come late or are lost.
   */
  double lag() {
    return lag;
  }

  private double lag(PastScan now) {
    PastScan deciding = now;
    int older = past.size() / 2; // how many scans back the one in the middle is
    for (PastScan each : past) {
      if (older == 0) {
        break;
      }
      deciding = each;
      older--;
    }
    return Duration.between(deciding.scan().measured(), now.scan().measured()).toNanos() / 1e9;
  }

  /** Scans of another shape, from the future, or too old to say anything. */
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
        result[beam] = column[(known - 1) / 2]; // of an even number the nearer: the safe side
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

  /** What an older scan says of a beam of the present one. */
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
