package org.dfra.behaviors.perceptual.pose;

import java.util.List;

/** Creates a Kalman filter's initial belief from an alignment. */
final class BeliefInitializer {

  /** Minimum standard deviation of the initial yaw, radians: the gyro bias is not yet known. */
  private static final double LEAST_YAW = 0.02;

  private BeliefInitializer() {}

  /**
   * Initializes a belief at the end of the track. It keeps the sensor parameters that an older
   * belief has estimated.
   *
   * @param belief an older one; ignored if invalid
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

  /**
   * The fixes' mean includes the mean of the GPS biases, and the yaw's error rotates the path
   * since.
   */
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
