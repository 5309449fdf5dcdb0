package org.dfra.drivers.uav.mavlink;

import java.util.Locale;
import org.dfra.core.config.Parameters;
import org.dfra.core.module.ParameterTable;
import org.dfra.core.module.ParameterTable.NumberRange;
import org.dfra.drivers.uav.mavlink.MavlinkMessage.GlobalPosition;
import org.dfra.flow.effector.FlightCommand;
import org.dfra.flow.effector.FlightCommand.Disarm;
import org.dfra.flow.effector.FlightCommand.GoTo;
import org.dfra.flow.effector.FlightCommand.TakeOff;
import org.dfra.flow.effector.FlightState.Phase;
import org.jspecify.annotations.Nullable;

/**
 * The parameters of a {@link MavlinkFlightImpl}, all of which can be set while it runs, and the
 * checks of commands against them. Safe for use by several threads.
 */
final class FlightLimits {

  private static final String FROM_AUTOPILOT = "autopilot";
  private static final NumberRange SEPARATION = NumberRange.of(-120, 100, "m");

  private final String module;
  private final VehicleState picture;
  private volatile double maxSpeed;
  private volatile double maxHeight;
  private volatile double rate;
  private volatile String separation;

  /**
   * @param module its path, for messages
   * @param settings its configured parameters
   * @param table where they are declared
   * @param picture uses the configured separation of geoid and ellipsoid
   * @throws org.dfra.core.config.ConfigurationException if one of them is wrong
   */
  FlightLimits(String module, Parameters settings, ParameterTable table, VehicleState picture) {
    this.module = module;
    this.picture = picture;
    maxSpeed = settings.number("max_speed", 10, 0.1, 100);
    maxHeight = settings.number("max_height", 120, 1, 10_000);
    rate = settings.number("rate", 5, 0.2, 50);
    separation = settings.find("geoid_separation").orElse(FROM_AUTOPILOT);
    if (!separation.equals(FROM_AUTOPILOT)) {
      picture.overrideSeparation(settings.number("geoid_separation", 0, -120, 100));
    }
    declareIn(table);
  }

  private void declareIn(ParameterTable table) {
    table.declareNumber(
        "max_speed",
        "a faster GoTo is flown at this",
        NumberRange.of(0.1, 100, "m/s"),
        () -> maxSpeed,
        value -> maxSpeed = value);
    table.declareNumber(
        "max_height",
        "above the place of take-off; greater heights are refused",
        NumberRange.of(1, 10_000, "m"),
        () -> maxHeight,
        value -> maxHeight = value);
    table.declareNumber(
        "rate",
        "states in a second",
        NumberRange.of(0.2, 50, "Hz"),
        () -> rate,
        value -> rate = value);
    table.declareText(
        "geoid_separation",
        "height of the geoid above the ellipsoid, metres; autopilot is what the autopilot reports",
        () -> separation,
        this::setSeparation);
    table.declareReadOnly(
        "current_geoid_separation", "the separation it goes by now", this::separation);
  }

  private void setSeparation(String text) {
    if (text.equals(FROM_AUTOPILOT)) {
      picture.overrideSeparation(null);
    } else {
      picture.overrideSeparation(number(text));
    }
    separation = text;
  }

  private static double number(String text) {
    double number;
    try {
      number = Double.parseDouble(text);
    } catch (NumberFormatException e) {
      number = Double.NaN;
    }
    if (!(number >= SEPARATION.min() && number <= SEPARATION.max())) {
      throw new IllegalArgumentException(SEPARATION + ", or autopilot");
    }
    return number;
  }

  private String separation() {
    @Nullable Double now = picture.separation();
    return now == null ? "not known" : String.format(Locale.ROOT, "%.2f m", now);
  }

  /** Maximum commanded speed over ground, metres per second. */
  double maxSpeed() {
    return maxSpeed;
  }

  /** Maximum commanded height above the take-off position, metres. */
  double maxHeight() {
    return maxHeight;
  }

  /** Required states per second. */
  double rate() {
    return rate;
  }

  /**
   * Checks a command against the limits and the current state.
   *
   * @param here the vehicle's position; null if unknown
   * @throws IllegalArgumentException if it is not allowed; the message explains what is
   */
  void check(FlightCommand command, @Nullable GlobalPosition here) {
    boolean stands = picture.phase() == Phase.ON_GROUND;
    if (command instanceof Disarm && !stands) {
      throw new IllegalArgumentException(
          module + " flies, and its motors are not stopped in the air; land it first");
    }
    if (command instanceof TakeOff requested) {
      if (!stands) {
        throw new IllegalArgumentException(module + " flies already; command a GoTo");
      }
      checkHeight(requested.height());
    }
    if (command instanceof GoTo requested) {
      if (stands) {
        throw new IllegalArgumentException(module + " is on the ground; command a take-off first");
      }
      @Nullable Double separation = picture.separation();
      if (here != null && separation != null) {
        double home = here.heightMsl() - here.heightAboveHome() + separation;
        checkHeight(requested.position().height() - home);
      }
    }
  }

  private void checkHeight(double height) {
    if (height > maxHeight) {
      throw new IllegalArgumentException(
          String.format(
              Locale.ROOT,
              "%s: height %.1f m above the place of take-off > max_height %.1f m; stay below it,"
                  + " or set the parameter",
              module,
              height,
              maxHeight));
    }
  }
}
