package org.dfra.cli.noise;

import java.util.List;
import java.util.Optional;
import org.dfra.event.Reading;
import org.dfra.flow.sensor.AngularRate;
import org.dfra.flow.sensor.GpsFix;
import org.dfra.flow.sensor.RangeScan;

/**
 * Computes noise parameters from the readings of a sensor whose robot is stopped. Readings arrive
 * in the order in which they were measured. Not thread-safe.
 */
public interface NoiseStudy {

  /**
   * A study for the sensor of such readings.
   *
   * @return empty if there is none for them
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

  /** Adds a reading; ignores one of another type. */
  void add(Reading reading);

  /** Number of readings. */
  long readings();

  /** The parameters by the readings so far. */
  List<NoiseParameter> parameters();

  /**
   * A measured noise parameter.
   *
   * @param name of the parameter, as in the estimators
   * @param value NaN if there were too few readings
   * @param unit its unit; may be empty
   * @param basis the data that it is based on, in words
   */
  record NoiseParameter(String name, double value, String unit, String basis) {}
}
