package org.dfra.cli.persona;

import java.math.BigDecimal;
import java.math.MathContext;
import java.math.RoundingMode;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.dfra.persona.Attributes;
import org.dfra.persona.ChainAttributes;
import org.dfra.persona.LocationAttributes;
import org.dfra.persona.ModuleAttributes;
import org.dfra.persona.PoseAttributes;
import org.dfra.persona.SensorAttributes;
import org.dfra.report.terminal.InlineFormat;

/** The capabilities of a module, a line for each kind of attributes, with units. */
final class Abilities {

  private static final String SUFFIX = "Attributes";

  private Abilities() {}

  static List<String> of(List<Attributes> attributes) {
    List<String> lines = new ArrayList<>();
    for (Attributes each : attributes) {
      if (!(each instanceof ModuleAttributes)) { // already printed above
        String line = line(each);
        if (!line.isEmpty()) {
          lines.add(name(each) + ": " + line);
        }
      }
    }
    lines.sort(String::compareTo);
    return lines;
  }

  /** {@code GpsReceiverAttributes} as {@code gps receiver}. */
  private static String name(Attributes attributes) {
    return attributes
        .getClass()
        .getSimpleName()
        .replaceFirst(SUFFIX + "$", "")
        .replaceAll("(?<=[a-z0-9])(?=[A-Z])", " ")
        .toLowerCase(Locale.ROOT);
  }

  private static String line(Attributes attributes) {
    if (attributes instanceof SensorAttributes sensor) {
      return sensor(sensor);
    } else if (attributes instanceof ChainAttributes chain) {
      return chain.inputs().isEmpty()
          ? "gives " + String.join(", ", chain.outputs())
          : "takes "
              + String.join(", ", chain.inputs())
              + ", gives "
              + String.join(", ", chain.outputs());
    } else if (attributes instanceof LocationAttributes place) {
      return String.format(
          Locale.ROOT,
          "was at %.6f°, %.6f°, %.1f m on %s",
          place.latitude(),
          place.longitude(),
          place.height(),
          place.measured());
    } else if (attributes instanceof PoseAttributes pose) {
      return String.format(
          Locale.ROOT,
          "mounted on %s at x %.3f m, y %.3f m, z %.3f m; roll %.3f, pitch %.3f, yaw %.3f rad",
          pose.parent(),
          pose.x(),
          pose.y(),
          pose.z(),
          pose.roll(),
          pose.pitch(),
          pose.yaw());
    }
    return InlineFormat.of(attributes);
  }

  /** With four significant digits at most. */
  private static String number(double value) {
    return new BigDecimal(value)
        .round(new MathContext(4, RoundingMode.HALF_EVEN))
        .stripTrailingZeros()
        .toPlainString();
  }

  private static String sensor(SensorAttributes sensor) {
    StringBuilder line = new StringBuilder("reads " + sensor.reading());
    if (sensor.maxRate() > 0) {
      line.append(" at ");
      if (sensor.minRate() < sensor.maxRate()) {
        line.append(number(sensor.minRate())).append(" to ");
      }
      line.append(number(sensor.maxRate())).append(" Hz");
    }
    if (!sensor.modes().isEmpty()) {
      line.append(", modes ").append(String.join(" ", sensor.modes()));
    }
    if (sensor.power() != null) {
      line.append(", draws ").append(number(sensor.power())).append(" W");
    }
    for (String each : sensor.preconditions()) {
      line.append("; needs: ").append(each);
    }
    return line.toString();
  }
}
