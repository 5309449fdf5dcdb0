package org.dfra.app.demo.raster;

import java.util.Locale;
import java.util.Optional;
import java.util.function.DoubleSupplier;
import org.dfra.app.demo.stage.Power;
import org.jspecify.annotations.Nullable;

/**
 * How fast the robots' time goes. In processes, where nobody says it, so fast as the computer can
 * keep up with: robots stop when their percepts are late.
 *
 * @param speed seconds of the robots' time in a second
 * @param slower why it goes slower than usual, a sentence; nothing where it does not
 */
record Pace(double speed, Optional<String> slower) {

  /** In one virtual machine, where nobody says another. */
  static final String USUAL = "5";

  /** In processes likewise: a dozen of them have two processors busy then for nine tenths. */
  static final String IN_PROCESSES = "2.5";

  /** Below this even that is taken to be too much. */
  private static final double ENOUGH = 0.6;

  /**
   * @param asked what the user asked for, where that is said
   * @param power of this computer, as a share of {@link Power}'s; asked for only where it counts
   */
  static Pace of(@Nullable Double asked, RasterSetup.Mode mode, DoubleSupplier power) {
    if (asked != null) {
      return new Pace(asked, Optional.empty());
    } else if (mode != RasterSetup.Mode.PROCESSES) {
      return new Pace(Double.parseDouble(USUAL), Optional.empty());
    }
    double usual = Double.parseDouble(IN_PROCESSES);
    double share = power.getAsDouble();
    if (share >= ENOUGH) {
      return new Pace(usual, Optional.empty());
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
    return new Pace(usual / 2, Optional.of(why));
  }
}
