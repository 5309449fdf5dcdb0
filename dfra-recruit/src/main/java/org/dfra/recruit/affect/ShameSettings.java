package org.dfra.recruit.affect;

import org.dfra.core.config.ConfigurationException;

/**
 * The constants of {@link Shame}. The published equations are not available: these are DFRA's own.
 *
 * @param gain g, above 0
 * @param exponent p, above 0: how strongly nearness increases shame
 * @param floor ε, above 0 and at most 1: even the farthest robot helps eventually
 * @param idleFactor b of a robot without work of its own, above 0
 * @param busyFactor b of a busy one
 * @param etaReference ETA from which on a place counts as farthest, seconds, above 0
 * @param batteryReserve charge below which the battery factor is minimal, 0 to 1; not the charge
 *     below which it does not help
 */
public record ShameSettings(
    double gain,
    double exponent,
    double floor,
    double idleFactor,
    double busyFactor,
    double etaReference,
    double batteryReserve) {

  /**
   * Defaults for a field.
   *
   * @param diagonal of the field, metres
   * @param speed of the robot, metres per second
   */
  public static ShameSettings forField(double diagonal, double speed) {
    return new ShameSettings(1.5, 2, 0.1, 1, 0.5, diagonal / speed, 0.2);
  }

  public ShameSettings {
    above("gain", gain);
    above("exponent", exponent);
    above("floor", floor);
    above("idle", idleFactor);
    above("busy", busyFactor);
    above("etaReference", etaReference);
    if (floor > 1 || !(batteryReserve >= 0 && batteryReserve < 1)) {
      throw new ConfigurationException(
          "floor "
              + floor
              + " is not at most 1, or reserve "
              + batteryReserve
              + " is outside 0 to 1");
    }
  }

  private static void above(String what, double value) {
    if (!(value > 0 && Double.isFinite(value))) {
      throw new ConfigurationException(what + " " + value + " is not above 0");
    }
  }
}
