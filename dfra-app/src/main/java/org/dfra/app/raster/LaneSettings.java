package org.dfra.app.raster;

import org.dfra.app.terminal.CommandFailure;
import org.dfra.app.terminal.ExitCode;
import org.jspecify.annotations.Nullable;

/**
 * How lanes lie, as an operator gives it on the command line.
 *
 * @param swath how wide a strip a robot sees, metres
 * @param spacing from lane to lane, metres, at most the swath
 */
public record LaneSettings(double swath, double spacing) {

  /** The swath, metres, where nothing else is said; a text, for the help. */
  public static final String SWATH = "2.5";

  /** The spacing as a part of the swath where nothing else is said; a text, for the help. */
  public static final String SPACING_FRACTION = "0.8";

  /** Metres. */
  private static final double NARROWEST = 0.1;

  /** Metres. */
  private static final double WIDEST = 100;

  /**
   * The lanes that were asked for.
   *
   * @param swath metres, or null where nothing was said
   * @param spacing metres, or null where nothing was said
   * @throws CommandFailure if one is none that can be
   */
  public static LaneSettings of(@Nullable Double swath, @Nullable Double spacing) {
    double seen = swath == null ? Double.parseDouble(SWATH) : swath;
    requireBetween("--swath", seen, NARROWEST, WIDEST, "");
    double apart = spacing == null ? Double.parseDouble(SPACING_FRACTION) * seen : spacing;
    requireBetween("--spacing", apart, NARROWEST, seen, ", the swath");
    return new LaneSettings(seen, apart);
  }

  /**
   * Refuses a number outside its limits.
   *
   * @param option that gave it
   * @param what the greatest is, after a comma; may be empty
   */
  public static void requireBetween(
      String option, double value, double least, double most, String what) {
    if (!(value >= least && value <= most)) {
      throw new CommandFailure(
          ExitCode.USAGE_ERROR,
          option + " " + value + " is outside " + text(least) + " to " + text(most) + what);
    }
  }

  private static String text(double value) {
    return value == Math.rint(value)
        ? Long.toString((long) value)
        : Double.toString(Math.round(value * 1000) / 1000.0);
  }
}
