package org.dfra.sim.device.laser;

import java.time.Duration;
import java.util.List;

/**
 * State of an emulated LMS 200 at power-on.
 *
 * @param warmUp duration of its self-test, during which it ignores input; then it reports that it
 *     is ready
 * @param baud bits per second that another driver left set, or 0 where it is switched on now and
 *     starts at 9600
 * @param unit unit of distances, as in its configuration: 0 cm, 1 mm
 * @param measuringMode as in its configuration: 0 to 6, 15
 * @param windowCleanness cleanness of its window, per cent; below 70 it reports pollution
 * @param errors stored errors, pairs of type and number
 * @param isConfigurationLocked whether it rejects every change of configuration and variant
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
   * A stored error.
   *
   * @param type 1 info, 2 warning, 3 error, 4 fatal; bit 7 is set where the error has ended
   * @param number which one
   */
  public record StoredError(int type, int number) {}

  public LmsEmulatorSettings {
    errors = List.copyOf(errors);
  }

  /** A clean one in factory state, powered on for a while, at 9600 baud: cm, 13 bits. */
  public static LmsEmulatorSettings factoryDefault() {
    return new LmsEmulatorSettings(Duration.ofSeconds(2), 9600, 0, 0, 100, List.of(), false);
  }

  /** The same, switched on now, with another self-test time. */
  public LmsEmulatorSettings withWarmUp(Duration test) {
    return new LmsEmulatorSettings(
        test, 0, unit, measuringMode, windowCleanness, errors, isConfigurationLocked);
  }

  /** The same at another baud rate. */
  public LmsEmulatorSettings withBaud(int rate) {
    return new LmsEmulatorSettings(
        warmUp, rate, unit, measuringMode, windowCleanness, errors, isConfigurationLocked);
  }

  /** The same with another configuration. */
  public LmsEmulatorSettings withConfiguration(int units, int mode) {
    return new LmsEmulatorSettings(
        warmUp, baud, units, mode, windowCleanness, errors, isConfigurationLocked);
  }

  /** The same with another window cleanness. */
  public LmsEmulatorSettings withWindowCleanness(int percent) {
    return new LmsEmulatorSettings(
        warmUp, baud, unit, measuringMode, percent, errors, isConfigurationLocked);
  }

  /** The same with these stored errors. */
  public LmsEmulatorSettings withErrors(StoredError... some) {
    return new LmsEmulatorSettings(
        warmUp, baud, unit, measuringMode, windowCleanness, List.of(some), isConfigurationLocked);
  }

  /** The same with a locked configuration. */
  public LmsEmulatorSettings withLockedConfiguration() {
    return new LmsEmulatorSettings(
        warmUp, baud, unit, measuringMode, windowCleanness, errors, true);
  }
}
