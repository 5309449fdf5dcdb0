package org.dfra.drivers.laser.lms;

import java.time.Duration;
import java.util.Locale;
import java.util.Optional;
import org.dfra.core.config.Parameters;
import org.dfra.core.module.ParameterTable;
import org.dfra.core.module.ParameterTable.NumberRange;
import org.dfra.drivers.laser.lms.LmsConfiguration.LmsUnit;
import org.dfra.drivers.link.LinkAddress;
import org.dfra.drivers.link.LinkSettings;
import org.dfra.drivers.link.SerialAddress;
import org.dfra.drivers.link.SimLinkRegistry.SimAddress;

/**
 * The required settings of the laser, from the driver's parameters. Safe for use by several
 * threads.
 */
final class LmsSettings {

  static final String FIELDS = "100 or 180, degrees";
  static final String RESOLUTIONS = "0.25, 0.5 or 1, degrees; 0.25 only with field_of_view 100";
  static final String MODES = "continuous or polled";
  private static final String KEEP = "keep";
  private static final Duration HOUR = Duration.ofHours(1);

  private final Optional<LmsBaud> baud;
  private final Optional<LmsUnit> unit;
  private final Optional<MeasuringMode> measuringMode;
  private volatile LmsVariant variant;
  private volatile boolean polled;
  private volatile double period; // seconds

  private LmsSettings(
      Optional<LmsBaud> baud,
      Optional<LmsUnit> unit,
      Optional<MeasuringMode> measuringMode,
      LmsVariant variant,
      boolean polled,
      double period) {
    this.baud = baud;
    this.unit = unit;
    this.measuringMode = measuringMode;
    this.variant = variant;
    this.polled = polled;
    this.period = period;
  }

  /**
   * Reads the parameters.
   *
   * @throws org.dfra.core.config.ConfigurationException if a parameter is wrong
   */
  static LmsSettings from(Parameters parameters) {
    return new LmsSettings(
        baudIn(parameters),
        unitIn(parameters),
        measuringModeIn(parameters),
        variantIn(parameters),
        polledIn(parameters),
        parameters.number("period", 1, 0.02, 60));
  }

  /** Declares the parameters that can be set while the driver runs. */
  void declareIn(ParameterTable table) {
    table.declareText("field_of_view", FIELDS, this::fieldOfView, this::setField);
    table.declareText("resolution", RESOLUTIONS, this::resolution, this::setResolution);
    table.declareText("mode", MODES, this::mode, this::setMode);
    table.declareNumber(
        "period",
        "from one scan to the next where polled",
        NumberRange.of(0.02, 60, "s"),
        this::period,
        this::setPeriod);
  }

  /** {@code idle_timeout}: seconds without clients before it becomes idle; 0 is never. */
  static Duration idleAfterIn(Parameters parameters) {
    return parameters.seconds("idle_timeout", Duration.ofSeconds(10), Duration.ZERO, HOUR);
  }

  private static Optional<LmsBaud> baudIn(Parameters parameters) {
    LinkAddress address = LinkSettings.address(parameters);
    if (parameters.find("baud").isEmpty()) {
      boolean isOurs = address instanceof SerialAddress || address instanceof SimAddress;
      return isOurs ? Optional.of(LmsBaud.B38400) : Optional.empty();
    }
    if (parameters.text("baud").equals(KEEP)) {
      return Optional.empty();
    }
    Optional<LmsBaud> asked = LmsBaud.of(number(parameters, "baud"));
    if (asked.isEmpty()) {
      throw parameters.fault("baud", "9600, 19200, 38400, 500000 or keep", null);
    }
    return asked;
  }

  private static Optional<LmsUnit> unitIn(Parameters parameters) {
    return switch (parameters.find("units").orElse("mm")) {
      case "mm" -> Optional.of(LmsUnit.MM);
      case "cm" -> Optional.of(LmsUnit.CM);
      case KEEP -> Optional.empty();
      default -> throw parameters.fault("units", "mm, cm or keep", null);
    };
  }

  private static Optional<MeasuringMode> measuringModeIn(Parameters parameters) {
    if (parameters.find("measuring_mode").orElse(KEEP).equals(KEEP)) {
      return Optional.empty();
    }
    double code = number(parameters, "measuring_mode");
    Optional<MeasuringMode> asked =
        code == Math.rint(code) ? MeasuringMode.of((int) code) : Optional.empty();
    if (asked.isEmpty()) {
      throw parameters.fault("measuring_mode", "0 to 6, 15 or keep", null);
    }
    return asked;
  }

  private static LmsVariant variantIn(Parameters parameters) {
    double degrees = parameters.number("field_of_view", 180, 100, 180);
    double resolution = parameters.number("resolution", 0.5, 0.25, 1);
    return variant(degrees, resolution)
        .orElseThrow(
            () ->
                degrees == 100 || degrees == 180
                    ? parameters.fault("resolution", RESOLUTIONS, null)
                    : parameters.fault("field_of_view", FIELDS, null));
  }

  private static Optional<LmsVariant> variant(double degrees, double resolution) {
    double hundredths = 100 * resolution;
    return degrees == Math.rint(degrees) && hundredths == Math.rint(hundredths)
        ? LmsVariant.of((int) degrees, (int) hundredths)
        : Optional.empty();
  }

  private static boolean polledIn(Parameters parameters) {
    return switch (parameters.find("mode").orElse("continuous")) {
      case "continuous" -> false;
      case "polled" -> true;
      default -> throw parameters.fault("mode", MODES, null);
    };
  }

  private static double number(Parameters parameters, String name) {
    try {
      return Double.parseDouble(parameters.text(name).trim());
    } catch (NumberFormatException e) {
      return Double.NaN;
    }
  }

  /** The required baud rate; empty where it is not to be changed. */
  Optional<LmsBaud> baud() {
    return baud;
  }

  /** The required unit; empty where it is not to be changed. */
  Optional<LmsUnit> unit() {
    return unit;
  }

  /** The required measuring mode; empty where it is not to be changed. */
  Optional<MeasuringMode> measuringMode() {
    return measuringMode;
  }

  LmsVariant variant() {
    return variant;
  }

  String fieldOfView() {
    return Integer.toString(variant.fieldDegrees());
  }

  String resolution() {
    double degrees = variant.stepHundredths() / 100.0;
    return degrees == 1 ? "1" : String.format(Locale.ROOT, "%s", degrees);
  }

  /** Sets the field of view; throws for an unsupported one. */
  synchronized void setField(String text) {
    variant = chosen(text, resolution(), FIELDS + "; 180 not with resolution 0.25");
  }

  synchronized void setResolution(String text) {
    variant = chosen(fieldOfView(), text, RESOLUTIONS);
  }

  private static LmsVariant chosen(String degrees, String resolution, String allowed) {
    try {
      return variant(Double.parseDouble(degrees.trim()), Double.parseDouble(resolution.trim()))
          .orElseThrow(() -> new IllegalArgumentException(allowed));
    } catch (NumberFormatException e) {
      throw new IllegalArgumentException(allowed, e);
    }
  }

  /** Whether every scan is requested (polled). */
  boolean isPolled() {
    return polled;
  }

  String mode() {
    return polled ? "polled" : "continuous";
  }

  void setMode(String text) {
    if (!text.equals("polled") && !text.equals("continuous")) {
      throw new IllegalArgumentException(MODES);
    }
    polled = text.equals("polled");
  }

  /** Period of scan requests, seconds. */
  double period() {
    return period;
  }

  void setPeriod(double seconds) {
    period = seconds;
  }
}
