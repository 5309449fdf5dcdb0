package org.dfra.behaviors.perceptual.pose;

/**
 * Transform of a section of dead reckoning to the map.
 *
 * @param yaw from the track's x to east, radians
 * @param certainty of the yaw: one over its variance, per square radian
 * @param trackX centre of the section on the track, metres
 * @param trackY likewise
 * @param east the same centre in the map, metres
 * @param north likewise
 * @param sigma standard deviation of the map's centre by white noise, metres
 * @param shares fraction of the fixes from each receiver
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

  /** The same, with its yaw fused with another yaw. */
  Alignment with(double otherYaw, double otherCertainty) {
    double re = certainty * Math.cos(yaw) + otherCertainty * Math.cos(otherYaw);
    double im = certainty * Math.sin(yaw) + otherCertainty * Math.sin(otherYaw);
    return new Alignment(
        Math.atan2(im, re), Math.hypot(re, im), trackX, trackY, east, north, sigma, shares);
  }

  /** Standard deviation of the yaw, radians; limited to that of an unknown yaw. */
  double yawSigma() {
    return Math.min(FixWindow.UNKNOWN_YAW_SIGMA, 1 / Math.sqrt(certainty));
  }

  /** Metres from the centre to a point on the track, eastward. */
  double eastward(DeadReckoningTrack.Pose pose) {
    return Math.cos(yaw) * (pose.x() - trackX) - Math.sin(yaw) * (pose.y() - trackY);
  }

  /** Metres from the centre to a point on the track, northward. */
  double northward(DeadReckoningTrack.Pose pose) {
    return Math.sin(yaw) * (pose.x() - trackX) + Math.cos(yaw) * (pose.y() - trackY);
  }

  /** Standard deviation of the position of a point on the track along its worst direction. */
  double positionSigma(DeadReckoningTrack.Pose pose, double biasSigma) {
    double far = Math.hypot(pose.x() - trackX, pose.y() - trackY) * yawSigma();
    double shared = 0;
    for (double share : shares) {
      shared += share * share;
    }
    return Math.sqrt(sigma * sigma + biasSigma * biasSigma * shared + far * far);
  }
}
