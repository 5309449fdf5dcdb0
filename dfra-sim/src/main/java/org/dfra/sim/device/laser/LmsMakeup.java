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
 * @param clean its window, per cent of a clean one; below 70 it complains
 * @param errors pairs of type and number that it remembers
 * @param isLocked whether it refuses every change of configuration and variant
 */
public record LmsMakeup(
    Duration warmUp,
    int baud,
    int unit,
    int measuringMode,
    int clean,
    List<Error> errors,
    boolean isLocked) {

  /**
   * An error that it remembers.
   *
   * @param type 1 info, 2 warning, 3 error, 4 fatal; with bit 7 where it is over
   * @param number which one
   */
  public record Error(int type, int number) {}

  public LmsMakeup {
    errors = List.copyOf(errors);
  }

  /** A clean one as it is sold, that has been on for a while, at 9600 baud: cm, 13 bits. */
  public static LmsMakeup sold() {
    return new LmsMakeup(Duration.ofSeconds(2), 9600, 0, 0, 100, List.of(), false);
  }

  /** The same, switched on only now, with another time for testing itself. */
  public LmsMakeup switchedOn(Duration test) {
    return new LmsMakeup(test, 0, unit, measuringMode, clean, errors, isLocked);
  }

  /** The same, left at another speed. */
  public LmsMakeup leftAt(int rate) {
    return new LmsMakeup(warmUp, rate, unit, measuringMode, clean, errors, isLocked);
  }

  /** The same, configured otherwise. */
  public LmsMakeup configured(int units, int mode) {
    return new LmsMakeup(warmUp, baud, units, mode, clean, errors, isLocked);
  }

  /** The same with a window that dirty. */
  public LmsMakeup cleanTo(int percent) {
    return new LmsMakeup(warmUp, baud, unit, measuringMode, percent, errors, isLocked);
  }

  /** The same, remembering these errors. */
  public LmsMakeup remembering(Error... some) {
    return new LmsMakeup(warmUp, baud, unit, measuringMode, clean, List.of(some), isLocked);
  }

  /** The same, refusing every change. */
  public LmsMakeup locked() {
    return new LmsMakeup(warmUp, baud, unit, measuringMode, clean, errors, true);
  }
}
