package org.dfra.cli.task;

import org.dfra.report.terminal.CommandFailure;
import org.dfra.report.terminal.ExitCode;
import org.jspecify.annotations.Nullable;

/**
 * The lanes' dimensions as given on the command line.
 *
 * @param swath width of the strip that a robot sees, metres
 * @param spacing from lane to lane, metres, at most the swath
 */
public record LaneSettings(double swath, double spacing) {

  /** The default swath, metres; a text, for the help. */
  public static final String SWATH = "2.5";

  /** The default spacing as a fraction of the swath; a text, for the help. */
  public static final String SPACING_FRACTION = "0.8";

  /** Metres. */
  private static final double NARROWEST = 0.1;

  /** Metres. */
  private static final double WIDEST = 100;

  /**
   * The dimensions for these options.
   *
   * @param swath metres, or null if not given
   * @param spacing metres, or null if not given
   * @throws CommandFailure if one is out of range
   */
  public static LaneSettings of(@Nullable Double swath, @Nullable Double spacing) {
    double seen = swath == null ? Double.parseDouble(SWATH) : swath;
    requireBetween("--swath", seen, NARROWEST, WIDEST, "");
    double separation = spacing == null ? Double.parseDouble(SPACING_FRACTION) * seen : spacing;
    requireBetween("--spacing", separation, NARROWEST, seen, ", the swath");
    return new LaneSettings(seen, separation);
  }

  /**
   * Rejects a number outside its limits.
   *
   * @param option the option's name
   * @param what description of the maximum, after a comma; may be empty
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
