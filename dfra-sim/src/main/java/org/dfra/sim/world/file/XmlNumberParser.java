package org.dfra.sim.world.file;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.regex.Pattern;
import org.dfra.core.config.XmlValues;
import org.dfra.sim.world.shape.PlanarShape.Polygon;
import org.dfra.sim.world.shape.PlanarShape.Vertex;
import org.jdom2.Element;

/** Parses numbers from attributes. It records an invalid number and returns a default instead. */
final class XmlNumberParser {

  private static final Pattern NUMBER =
      Pattern.compile("[-+]?([0-9]+\\.?[0-9]*|\\.[0-9]+)([eE][-+]?[0-9]{1,3})?");
  private static final Pattern COLOUR = Pattern.compile("#[0-9A-Fa-f]{6}");

  private final XmlValues values;

  XmlNumberParser(XmlValues values) {
    this.values = values;
  }

  /** The attribute as a number; the default where it is absent or invalid. */
  double number(Element element, String name, double absent) {
    String text = values.attribute(element, name);
    if (text == null) {
      return absent;
    }
    OptionalDouble number = parse(text);
    if (number.isEmpty()) {
      values.check(element, name + " is \"" + text + "\"; write a number, such as 1.5");
    }
    return number.orElse(absent);
  }

  /** The number of a text, if it is one: neither NaN nor infinite nor hexadecimal. */
  static OptionalDouble parse(String text) {
    if (!NUMBER.matcher(text.strip()).matches()) {
      return OptionalDouble.empty();
    }
    double number = Double.parseDouble(text.strip());
    return Double.isFinite(number) ? OptionalDouble.of(number) : OptionalDouble.empty();
  }

  /** The attribute {@code seed}; 1 where it is absent. */
  long seed(Element element) {
    String text = values.attribute(element, "seed", "1");
    try {
      return text == null ? 1 : Long.parseLong(text.strip());
    } catch (NumberFormatException e) {
      values.check(element, "seed is \"" + text + "\"; write a whole number, such as 1");
      return 1;
    }
  }

  /** The attribute {@code colour}, 0xRRGGBB. */
  int colour(Element element, int absent) {
    String text = values.attribute(element, "colour");
    if (text == null) {
      return absent;
    }
    Optional<Integer> colour = colour(text);
    if (colour.isEmpty()) {
      values.check(element, colourComplaint(text));
    }
    return colour.orElse(absent);
  }

  /** The colour of a text such as {@code #3F4526}. */
  static Optional<Integer> colour(String text) {
    return COLOUR.matcher(text).matches()
        ? Optional.of(Integer.parseInt(text.substring(1), 16))
        : Optional.empty();
  }

  static String colourComplaint(String text) {
    return "colour is \"" + text + "\"; write red, green and blue as in #3F4526";
  }

  /** The attribute {@code points}: pairs of east and north, separated by spaces. */
  Optional<Polygon> polygon(Element element) {
    String text = values.attribute(element, "points");
    if (text == null) {
      return Optional.empty();
    }
    List<Vertex> corners = new ArrayList<>();
    for (String pair : text.strip().split("\\s+")) {
      String[] both = pair.split(",", -1);
      OptionalDouble east = parse(both[0]);
      OptionalDouble north = both.length == 2 ? parse(both[1]) : OptionalDouble.empty();
      if (east.isEmpty() || north.isEmpty()) {
        values.check(
            element,
            "\"" + pair + "\" in points is not a point; write east,north in metres, as in 12.5,3");
        return Optional.empty();
      }
      corners.add(new Vertex(east.getAsDouble(), north.getAsDouble()));
    }
    try {
      return Optional.of(new Polygon(corners));
    } catch (IllegalArgumentException e) {
      values.check(element, e.getMessage());
      return Optional.empty();
    }
  }
}
