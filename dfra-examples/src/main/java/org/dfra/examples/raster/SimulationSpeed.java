package org.dfra.examples.raster;

import java.util.Locale;
import java.util.Optional;
import java.util.function.DoubleSupplier;
import org.dfra.examples.harness.CpuSpeed;
import org.jspecify.annotations.Nullable;

/**
 * The speed of the robots' clock. In processes, by default, as fast as the computer can sustain:
 * robots stop when their percepts are late.
 *
 * @param speed seconds of the robots' clock per second
 * @param slowdownReason why it is slower than usual, a sentence; empty if it is not
 */
public record SimulationSpeed(double speed, Optional<String> slowdownReason) {

  /** Default in one JVM. */
  static final String DEFAULT_IN_ONE_JVM = "5";

  /** Default in processes: a dozen of them load two processors to 90 %. */
  static final String IN_PROCESSES = "2.5";

  /** Below this speed of the computer, the default is more than it can sustain. */
  private static final double MIN_CPU_SPEED = 0.9;

  /** The speed below that. */
  private static final double SLOW = 1.25;

  /** Below this speed of the computer, it is the speed of a real robot. */
  private static final double MIN_CPU_SPEED_OF_SLOW = 0.6;

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
    double slower = share >= MIN_CPU_SPEED_OF_SLOW ? SLOW : 1;
    String why =
        String.format(
            Locale.ROOT,
            "This computer now has %.0f %% of the speed that the simulation needs at %s times real"
                + " time, so it runs %s and takes longer. If other programs use the computer, try"
                + " again later, or set --speed.",
            100 * share,
            IN_PROCESSES,
            slower == 1 ? "in real time" : "at " + slower + " times real time");
    return new SimulationSpeed(slower, Optional.of(why));
  }
}
