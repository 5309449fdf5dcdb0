package org.dfra.behaviors.perceptual.pose;

/**
 * How a stretch of dead reckoning lies in the map.
 *
 * @param yaw from the track's x to east, radians
 * @param certainty of the yaw: one over its variance, per square radian
 * @param trackX centre of the stretch on the track, metres
 * @param trackY likewise
 * @param east the same centre in the map, metres
 * @param north likewise
 * @param sigma standard deviation of the map's centre by white noise, metres
 * @param shares part of the fixes that each receiver gave
 */
record Alignment(
    double yaw,
    double certainty,
    double trackX,
    double trackY,
    double east,
    double north,
    double sigma,
    double[] shares) {

  /** The same, its yaw weighed against another that is known besides. */
  Alignment with(double otherYaw, double otherCertainty) {
    double re = certainty * Math.cos(yaw) + otherCertainty * Math.cos(otherYaw);
    double im = certainty * Math.sin(yaw) + otherCertainty * Math.sin(otherYaw);
    return new Alignment(
        Math.atan2(im, re), Math.hypot(re, im), trackX, trackY, east, north, sigma, shares);
  }

  /** Standard deviation of the yaw, radians; that of any yaw at all where it is less certain. */
  double yawSigma() {
    return Math.min(FixWindow.UNKNOWN_YAW_SIGMA, 1 / Math.sqrt(certainty));
  }

  /** Metres from the centre to a place on the track, eastward. */
  double eastward(DeadReckoningTrack.Pose pose) {
    return Math.cos(yaw) * (pose.x() - trackX) - Math.sin(yaw) * (pose.y() - trackY);
  }

  /** Metres from the centre to a place on the track, northward. */
  double northward(DeadReckoningTrack.Pose pose) {
    return Math.sin(yaw) * (pose.x() - trackX) + Math.cos(yaw) * (pose.y() - trackY);
  }

  /** Standard deviation of the position of a place on the track along its worst direction. */
  double positionSigma(DeadReckoningTrack.Pose pose, double bias) {
    double far = Math.hypot(pose.x() - trackX, pose.y() - trackY) * yawSigma();
    double shared = 0;
    for (double share : shares) {
      shared += share * share;
    }
    return Math.sqrt(sigma * sigma + bias * bias * shared + far * far);
  }
}
