package org.dfra.app.demo.raster;

import java.util.Locale;
import java.util.Optional;
import java.util.function.DoubleSupplier;
import org.dfra.app.demo.harness.CpuSpeed;
import org.jspecify.annotations.Nullable;

/**
 * The speed of the robots' clock. In processes, by default, as fast as the computer can sustain:
 * robots stop when their percepts are late.
 *
 * @param speed seconds of the robots' clock per second
 * @param slowdownReason why it is slower than usual, a sentence; empty if it is not
 */
record SimulationSpeed(double speed, Optional<String> slowdownReason) {

  /** Default in one JVM. */
  static final String DEFAULT_IN_ONE_JVM = "5";

  /** Default in processes: a dozen of them load two processors to 90 %. */
  static final String IN_PROCESSES = "2.5";

  /** Below this speed of the computer, even the default is too fast. */
  private static final double MIN_CPU_SPEED = 0.6;

  /**
   * @param asked the speed that the user requested, if any
   * @param cpuSpeed of this computer, relative to the reference of {@link CpuSpeed}; evaluated only
   *     if needed
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
