package org.dfra.behaviors.perceptual.pose;

import java.util.List;

/** Makes the belief that a Kalman filter begins with of an alignment. */
final class BeliefInitializer {

  /** The first yaw is never better than this, radians: the gyro was not yet known. */
  private static final double LEAST_YAW = 0.02;

  private BeliefInitializer() {}

  /**
   * Begins a belief where the track ends. What an older belief had learnt of the sensors is kept.
   *
   * @param belief an older one or, not sound, none
   */
  static void initialize(
      Belief belief, Alignment alignment, DeadReckoning reckoning, TrackerSettings settings) {
    DeadReckoningTrack track = reckoning.track();
    boolean hasLearnt = belief.isValid();
    Belief older = new Belief(settings);
    older.set(belief);
    belief.initialize(
        reckoning.steps().time(),
        alignment.east() + alignment.eastward(track.end()),
        alignment.north() + alignment.northward(track.end()),
        alignment.yaw() + track.end().yaw());
    spread(belief, alignment, track.end());
    if (hasLearnt) {
      for (int kept : List.of(Belief.GYRO_BIAS, Belief.WHEEL_SCALE, Belief.WHEEL_YAW_SCALE)) {
        belief.setUncorrelated(kept, older.get(kept), Math.sqrt(older.variance(kept)));
      }
    } else if (track.stationarySeconds() > 0) {
      double sigma =
          settings.gyro().noiseDensity() / Math.sqrt(track.stationarySeconds())
              + settings.gyro().biasRandomWalk();
      belief.setUncorrelated(
          Belief.GYRO_BIAS, track.gyroBias(), Math.min(settings.gyro().biasSigma(), sigma));
    }
  }

  /** The fixes' mean has the slow errors' mean in it, and the yaw's error turns the way since. */
  private static void spread(Belief belief, Alignment alignment, DeadReckoningTrack.Pose end) {
    double e = alignment.eastward(end);
    double n = alignment.northward(end);
    double yaw = alignment.yawSigma() * alignment.yawSigma() + LEAST_YAW * LEAST_YAW;
    double white = alignment.sigma() * alignment.sigma();
    belief.covariance.set(Belief.YAW, Belief.YAW, yaw);
    belief.covariance.set(Belief.EAST, Belief.EAST, white + n * n * yaw);
    belief.covariance.set(Belief.NORTH, Belief.NORTH, white + e * e * yaw);
    tie(belief, Belief.EAST, Belief.NORTH, -e * n * yaw);
    tie(belief, Belief.EAST, Belief.YAW, -n * yaw);
    tie(belief, Belief.NORTH, Belief.YAW, e * yaw);
    for (int slot = 0; slot < FixPreprocessor.MAX_RECEIVERS; slot++) {
      double share = alignment.shares()[slot];
      for (int axis = 0; axis < 2; axis++) {
        int slow = Belief.GPS_BIAS + 2 * slot + axis;
        double variance = belief.variance(slow);
        int place = axis == 0 ? Belief.EAST : Belief.NORTH;
        belief.covariance.add(place, place, share * share * variance);
        tie(belief, place, slow, -share * variance);
      }
    }
  }

  private static void tie(Belief belief, int one, int other, double covariance) {
    belief.covariance.set(one, other, covariance);
    belief.covariance.set(other, one, covariance);
  }
}
