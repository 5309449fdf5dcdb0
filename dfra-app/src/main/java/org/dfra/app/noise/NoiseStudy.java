package org.dfra.app.noise;

import java.util.List;
import java.util.Optional;
import org.dfra.event.Reading;
import org.dfra.flow.sensor.AngularRate;
import org.dfra.flow.sensor.GpsFix;
import org.dfra.flow.sensor.RangeScan;

/**
 * Makes figures of what a sensor tells while its robot stands. The readings come in the order in
 * which they were measured. Not safe for several threads by itself.
 */
public interface NoiseStudy {

  /**
   * One of the sensor that tells such readings.
   *
   * @return nothing where there is none for them
   */
  static Optional<NoiseStudy> of(Reading first) {
    if (first instanceof GpsFix) {
      return Optional.of(new GpsNoiseStudy());
    } else if (first instanceof AngularRate) {
      return Optional.of(new GyroNoiseStudy());
    } else if (first instanceof RangeScan) {
      return Optional.of(new LaserNoiseStudy());
    }
    return Optional.empty();
  }

  /** Takes another reading; one of another kind is passed over. */
  void add(Reading reading);

  /** How many were taken. */
  long readings();

  /** What they amount to so far. */
  List<NoiseParameter> parameters();
}
