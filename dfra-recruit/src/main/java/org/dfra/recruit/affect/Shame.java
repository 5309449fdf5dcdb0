package org.dfra.recruit.affect;

import org.dfra.core.config.ConfigurationException;

/**
 * Models the growing shame of ignoring a call for help. With each call received while the robot
 * could help,
 *
 * <pre>
 *   s &lt;- min(1, s + g b f max(ε, (1 - min(1, ETA / ETA_ref))^p))
 * </pre>
 *
 * <p>and the robot offers help once s is 1. b is 1 for an idle robot and less for a busy one. f is
 * twice the usable charge, the battery's charge above the reserve as a fraction of a full
 * battery's: at most 1, and at least 0.2, so the liveness floor ε holds for all. s returns to 0
 * when the robot was chosen (atonement) or another was (relief). The idea is from the thesis; the
 * equation and its constants are DFRA's own.
 */
public final class Shame implements Affect {

  private static final double LEAST_BATTERY_FACTOR = 0.2;

  private final ShameSettings settings;
  private double level;

  public Shame(ShameSettings settings) {
    this.settings = settings;
  }

  @Override
  public double level() {
    return level;
  }

  @Override
  public void stimulate(Stimulus stimulus) {
    double nearness = 1 - Math.min(1, stimulus.etaSeconds() / settings.etaReference());
    double want = Math.max(settings.floor(), Math.pow(nearness, settings.exponent()));
    double work = stimulus.busy() ? settings.busyFactor() : settings.idleFactor();
    level = Math.min(1, level + settings.gain() * work * batteryFactor(stimulus.battery()) * want);
  }

  private double batteryFactor(double battery) {
    double usable = (battery - settings.batteryReserve()) / (1 - settings.batteryReserve());
    return Math.max(LEAST_BATTERY_FACTOR, Math.min(1, 2 * usable));
  }

  @Override
  public void onHelping() {
    level = 0;
  }

  @Override
  public void onRelease() {
    level = 0;
  }

  @Override
  public void restore(double kept) {
    level = kept;
  }

  /**
   * The constants of {@link Shame}. The published equations are not available: these are DFRA's
   * own.
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

    /** The same with another gain and another exponent. */
    public ShameSettings withGain(double otherGain, double otherExponent) {
      return new ShameSettings(
          otherGain, otherExponent, floor, idleFactor, busyFactor, etaReference, batteryReserve);
    }

    public ShameSettings {
      above("gain", gain);
      above("exponent", exponent);
      above("floor", floor);
      above("idleFactor", idleFactor);
      above("busyFactor", busyFactor);
      above("etaReference", etaReference);
      if (floor > 1 || !(batteryReserve >= 0 && batteryReserve < 1)) {
        throw new ConfigurationException(
            "shame needs a floor of at most 1 and a battery reserve of 0 to less than 1, not "
                + floor
                + " and "
                + batteryReserve);
      }
    }

    private static void above(String what, double value) {
      if (!(value > 0 && Double.isFinite(value))) {
        throw new ConfigurationException(what + " " + value + " must be above 0 and finite");
      }
    }
  }
}
