package org.dfra.behaviors.perceptual.pose;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import org.dfra.behaviors.perceptual.pose.FilterInput.LocalFix;

/**
 * The last fixes, each with the antenna's point on the track at that time. The track is aligned to
 * the fixes by least squares: rotated by the angle for which the fixes, each minus the mean of its
 * receiver, fit best (so a receiver's bias does not affect the yaw), then translated mean to mean.
 * Courses over ground contribute to the angle as well.
 *
 * <p>With complex numbers, d a point on the track and f its fix, both minus their means, and c the
 * angle from the track to a course: Z = Σ conj(d)·f / σ² + Σ exp(i·c) / σ_c². The angle is arg Z,
 * one over its variance |Z|.
 */
final class FixWindow {

  /** Standard deviation of an unknown yaw, radians: π/√3. */
  static final double UNKNOWN_YAW_SIGMA = 1.8138;

  private static final int MOST = 256;

  /** A fix is an outlier if its residual exceeds this multiple of the median, and its noise. */
  private static final double OUTLYING = 4;

  /** Above this yaw rate a receiver's course lags, radians per second. */
  static final double MAX_COURSE_YAW_RATE = 0.2;

  /** Below this wheel speed, metres per second, a course is unusable. */
  static final double MIN_COURSE_SPEED = 0.2;

  private final TrackerSettings settings;
  private final List<Entry> entries = new ArrayList<>();

  /** A fix, the antenna's point on the track, and the angle from the track to its course. */
  private record Entry(LocalFix fix, double x, double y, double courseAngle) {}

  FixWindow(TrackerSettings settings) {
    this.settings = settings;
  }

  /**
   * Adds a fix.
   *
   * @param pose of the robot on the track at the time of the fix
   * @param speed of the robot then, forward is +, metres per second
   * @param yawRate of the robot then, radians per second
   */
  void add(LocalFix fix, DeadReckoningTrack.Pose pose, double speed, double yawRate) {
    double cos = Math.cos(pose.yaw());
    double sin = Math.sin(pose.yaw());
    boolean hasCourse =
        !Double.isNaN(fix.course())
            && Math.abs(speed) > MIN_COURSE_SPEED
            && Math.abs(yawRate) < MAX_COURSE_YAW_RATE;
    double ahead = fix.antennaDirection(speed, yawRate) + pose.yaw();
    entries.add(
        new Entry(
            fix,
            pose.x() + cos * fix.forward() - sin * fix.left(),
            pose.y() + sin * fix.forward() + cos * fix.left(),
            hasCourse ? fix.course() - ahead : Double.NaN));
    long oldest = fix.time() - settings.fixWindow().toNanos();
    entries.removeIf(entry -> entry.fix.time() < oldest);
    if (entries.size() > MOST) {
      entries.remove(0);
    }
  }

  void clear() {
    entries.clear();
  }

  /** Drops fixes from before that time. */
  void clearBefore(long time) {
    entries.removeIf(entry -> entry.fix.time() < time);
  }

  /** The best alignment, without outliers; empty if there is no fix. */
  Optional<Alignment> align() {
    if (entries.isEmpty()) {
      return Optional.empty();
    }
    Alignment first = fit(entries);
    double[] residuals = entries.stream().mapToDouble(entry -> residual(first, entry)).toArray();
    double[] sorted = residuals.clone();
    Arrays.sort(sorted);
    double median = sorted[sorted.length / 2];
    List<Entry> good = new ArrayList<>();
    for (int i = 0; i < residuals.length; i++) {
      double noise = Math.hypot(entries.get(i).fix.sigma(), settings.gps().biasSigma());
      if (residuals[i] <= OUTLYING * Math.max(median, noise)) {
        good.add(entries.get(i));
      }
    }
    return Optional.of(good.isEmpty() || good.size() == entries.size() ? first : fit(good));
  }

  private static double residual(Alignment to, Entry entry) {
    DeadReckoningTrack.Pose place = new DeadReckoningTrack.Pose(entry.x, entry.y, 0);
    return Math.hypot(
        to.east() + to.eastward(place) - entry.fix.east(),
        to.north() + to.northward(place) - entry.fix.north());
  }

  private Alignment fit(List<Entry> chosen) {
    double[] centre = new double[4];
    double[] z = new double[2];
    double[] shares = new double[FixPreprocessor.MAX_RECEIVERS];
    double variance = 0;
    for (int slot = 0; slot < FixPreprocessor.MAX_RECEIVERS; slot++) {
      double[] mean = mean(chosen, slot);
      shares[slot] = mean[4] / chosen.size();
      for (int i = 0; i < centre.length; i++) {
        centre[i] += shares[slot] * mean[i];
      }
      addPositions(chosen, slot, mean, z);
    }
    for (Entry entry : chosen) {
      variance += entry.fix.sigma() * entry.fix.sigma();
      if (!Double.isNaN(entry.courseAngle)) {
        double sigma = settings.gps().courseSigma(entry.fix.speed());
        z[0] += Math.cos(entry.courseAngle) / (sigma * sigma);
        z[1] += Math.sin(entry.courseAngle) / (sigma * sigma);
      }
    }
    return new Alignment(
        Math.atan2(z[1], z[0]),
        Math.hypot(z[0], z[1]),
        centre[0],
        centre[1],
        centre[2],
        centre[3],
        Math.sqrt(variance) / chosen.size(),
        shares);
  }

  /** Adds a receiver's conj(d)·f / σ² to z, real and imaginary part. */
  private static void addPositions(List<Entry> chosen, int slot, double[] mean, double[] z) {
    for (Entry entry : chosen) {
      if (entry.fix.slot() == slot) {
        double weight = 1 / (entry.fix.sigma() * entry.fix.sigma());
        double x = entry.x - mean[0];
        double y = entry.y - mean[1];
        double e = entry.fix.east() - mean[2];
        double n = entry.fix.north() - mean[3];
        z[0] += weight * (x * e + y * n);
        z[1] += weight * (x * n - y * e);
      }
    }
  }

  /** Mean x, y, east, north of a receiver's entries, and their number. */
  private static double[] mean(List<Entry> chosen, int slot) {
    double[] sum = new double[5];
    for (Entry entry : chosen) {
      if (entry.fix.slot() == slot) {
        sum[0] += entry.x;
        sum[1] += entry.y;
        sum[2] += entry.fix.east();
        sum[3] += entry.fix.north();
        sum[4]++;
      }
    }
    for (int i = 0; i < 4 && sum[4] > 0; i++) {
      sum[i] /= sum[4];
    }
    return sum;
  }
}
