package org.dfra.app.demo.raster;

import java.util.Locale;
import java.util.Optional;
import java.util.function.DoubleSupplier;
import org.dfra.app.demo.harness.CpuSpeed;
import org.jspecify.annotations.Nullable;

/**
 * How fast the robots' time goes. In processes, where nobody says it, so fast as the computer can
 * keep up with: robots stop when their percepts are late.
 *
 * @param speed seconds of the robots' time in a second
 * @param slowdownReason why it goes slower than usual, a sentence; nothing where it does not
 */
record SimulationSpeed(double speed, Optional<String> slowdownReason) {

  /** In one virtual machine, where nobody says another. */
  static final String DEFAULT_IN_ONE_JVM = "5";

  /** In processes likewise: a dozen of them have two processors busy then for nine tenths. */
  static final String IN_PROCESSES = "2.5";

  /** Below this even that is taken to be too much. */
  private static final double MIN_CPU_SPEED = 0.6;

  /**
   * @param asked what the user asked for, where that is said
   * @param cpuSpeed of this computer, as a share of {@link CpuSpeed}'s; asked for only where it
   *     counts
   */
  static SimulationSpeed of(
      @Nullable Double asked, RasterSetup.Mode mode, DoubleSupplier cpuSpeed) {
    if (asked != null) {
      return new SimulationSpeed(asked, Optional.empty());
    } else if (mode != RasterSetup.Mode.PROCESSES) {
      return new SimulationSpeed(Double.parseDouble(DEFAULT_IN_ONE_JVM), Optional.empty());
    }
    double usual = Double.parseDouble(IN_PROCESSES);
    double share = cpuSpeed.getAsDouble();
    if (share >= MIN_CPU_SPEED) {
      return new SimulationSpeed(usual, Optional.empty());
    }
    String why =
        String.format(
            Locale.ROOT,
            "This computer can do %.0f %% now of what it takes to play it %s times as fast as real"
                + " time; so it goes %s times as fast, and takes twice as long. Where it is busy,"
                + " try again later, or with --speed.",
            100 * share,
            IN_PROCESSES,
            usual / 2);
    return new SimulationSpeed(usual / 2, Optional.of(why));
  }
}
