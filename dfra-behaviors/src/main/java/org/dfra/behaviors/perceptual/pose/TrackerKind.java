package org.dfra.behaviors.perceptual.pose;

import org.dfra.geometry.GeoPosition;
import org.jspecify.annotations.Nullable;

/** The methods of pose tracking. */
public enum TrackerKind {
  /** An extended Kalman filter: {@link KalmanTracker}. */
  KALMAN,
  /** The last fixes against dead reckoning: {@link FixWindowTracker}. */
  HISTORY,
  /** The last fix as it is: {@link RawGpsTracker}. */
  RAW;

  /**
   * A new tracker of this kind.
   *
   * @param frame name of the frame of its estimates, e.g. {@code atrv1/map}
   * @param datum origin of that frame; null to use the position of the first fix
   */
  public PoseTracker create(TrackerSettings settings, String frame, @Nullable GeoPosition datum) {
    return create(settings, frame, datum, null);
  }

  /**
   * The same.
   *
   * @param known prior of the initial yaw, which only {@link #KALMAN} uses; null for none
   */
  public PoseTracker create(
      TrackerSettings settings,
      String frame,
      @Nullable GeoPosition datum,
      KalmanTracker.@Nullable InitialYaw known) {
    return switch (this) {
      case KALMAN -> new KalmanTracker(settings, frame, datum, known);
      case HISTORY -> new FixWindowTracker(settings, frame, datum);
      case RAW -> new RawGpsTracker(settings, frame, datum);
    };
  }
}
