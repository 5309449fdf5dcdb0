package org.dfra.sim.device.laser;

import java.time.Duration;
import java.util.List;

/**
 * What an emulated LMS 200 is like when it is switched on.
 *
 * @param warmUp how long after that it tests itself and is deaf; then it tells that it is ready
 * @param baud bits per second at which it was left by another driver, or 0 where it is switched on
 *     only now and wakes at 9600
 * @param unit what it counts in, as in its configuration: 0 cm, 1 mm
 * @param measuringMode as in its configuration: 0 to 6, 15
 * @param windowCleanness its window, per cent of a clean one; below 70 it complains
 * @param errors pairs of type and number that it remembers
 * @param isConfigurationLocked whether it refuses every change of configuration and variant
 */
public record LmsEmulatorSettings(
    Duration warmUp,
    int baud,
    int unit,
    int measuringMode,
    int windowCleanness,
    List<StoredError> errors,
    boolean isConfigurationLocked) {

  /**
   * An error that it remembers.
   *
   * @param type 1 info, 2 warning, 3 error, 4 fatal; with bit 7 where it is over
   * @param number which one
   */
  public record StoredError(int type, int number) {}

  public LmsEmulatorSettings {
    errors = List.copyOf(errors);
  }

  /** A clean one as it is sold, that has been on for a while, at 9600 baud: cm, 13 bits. */
  public static LmsEmulatorSettings factoryDefault() {
    return new LmsEmulatorSettings(Duration.ofSeconds(2), 9600, 0, 0, 100, List.of(), false);
  }

  /** The same, switched on only now, with another time for testing itself. */
  public LmsEmulatorSettings withWarmUp(Duration test) {
    return new LmsEmulatorSettings(
        test, 0, unit, measuringMode, windowCleanness, errors, isConfigurationLocked);
  }

  /** The same, left at another speed. */
  public LmsEmulatorSettings withBaud(int rate) {
    return new LmsEmulatorSettings(
        warmUp, rate, unit, measuringMode, windowCleanness, errors, isConfigurationLocked);
  }

  /** The same, configured otherwise. */
  public LmsEmulatorSettings withConfiguration(int units, int mode) {
    return new LmsEmulatorSettings(
        warmUp, baud, units, mode, windowCleanness, errors, isConfigurationLocked);
  }

  /** The same with a window that dirty. */
  public LmsEmulatorSettings withWindowCleanness(int percent) {
    return new LmsEmulatorSettings(
        warmUp, baud, unit, measuringMode, percent, errors, isConfigurationLocked);
  }

  /** The same, remembering these errors. */
  public LmsEmulatorSettings withErrors(StoredError... some) {
    return new LmsEmulatorSettings(
        warmUp, baud, unit, measuringMode, windowCleanness, List.of(some), isConfigurationLocked);
  }

  /** The same, refusing every change. */
  public LmsEmulatorSettings withLockedConfiguration() {
    return new LmsEmulatorSettings(
        warmUp, baud, unit, measuringMode, windowCleanness, errors, true);
  }
}
