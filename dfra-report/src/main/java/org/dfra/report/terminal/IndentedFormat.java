package org.dfra.report.terminal;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.BinaryNode;
import java.math.BigDecimal;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/** Any value as indented lines {@code name: value}, for text output. */
final class IndentedFormat {

  private static final String INDENT = "  ";
  private static final int LONGEST_LIST = 24;

  private final List<String> lines = new ArrayList<>();

  private IndentedFormat() {}

  static List<String> of(Object value) {
    IndentedFormat outline = new IndentedFormat();
    JsonNode tree = Json.tree(value);
    if (tree.isContainerNode() && !tree.isEmpty()) {
      outline.children(tree, "");
    } else {
      outline.lines.add(text(tree));
    }
    return outline.lines;
  }

  /**
   * A line wrapped at these columns. Continuation lines are indented further than the next line's
   * name can be.
   */
  static List<String> folded(String line, int columns) {
    String text = line.stripLeading();
    int margin = line.length() - text.length() + (text.startsWith("- ") ? 2 : 0);
    return TextWrap.hangingIndent(line, columns, margin + 2 * INDENT.length());
  }

  private void children(JsonNode node, String indent) {
    if (node.isObject()) {
      node.properties().forEach(each -> named(words(each.getKey()), each.getValue(), indent));
    } else {
      node.elements().forEachRemaining(each -> element(each, indent));
    }
  }

  private void named(String name, JsonNode value, String indent) {
    if (isShort(value)) {
      lines.add(indent + name + ": " + text(value));
    } else {
      lines.add(indent + name + ":");
      children(value, indent + INDENT);
    }
  }

  private void element(JsonNode value, String indent) {
    if (isShort(value)) {
      lines.add(indent + "- " + text(value));
      return;
    }
    int first = lines.size();
    children(value, indent + INDENT);
    if (lines.size() > first) {
      lines.set(first, indent + "- " + lines.get(first).strip());
    }
  }

  private static boolean isShort(JsonNode value) {
    return value.isValueNode()
        || value.isEmpty()
        || (value.isArray() && allAreValues(value) && text(value).length() <= 70);
  }

  private static boolean allAreValues(JsonNode array) {
    for (JsonNode each : array) {
      if (!each.isValueNode()) {
        return false;
      }
    }
    return true;
  }

  /** Whether it has so many numbers, such as a scan, that they are summarised. */
  static boolean isLong(JsonNode value) {
    return value.isArray() && value.size() > LONGEST_LIST && value.get(0).isNumber();
  }

  /** {@code 361 numbers, 0.52 to 7.98}; numbers that are not finite are only counted. */
  private static String summary(JsonNode numbers) {
    double least = Double.POSITIVE_INFINITY;
    double most = Double.NEGATIVE_INFINITY;
    for (JsonNode each : numbers) {
      double number = each.asDouble(Double.NaN);
      if (Double.isFinite(number)) {
        least = Math.min(least, number);
        most = Math.max(most, number);
      }
    }
    return numbers.size()
        + " numbers"
        + (least > most ? ", none finite" : ", " + number(least) + " to " + number(most));
  }

  /** A value in a few words. */
  static String text(JsonNode value) {
    if (value.isBinary()) {
      return ((BinaryNode) value).binaryValue().length + " bytes";
    } else if (isLong(value)) {
      return summary(value);
    } else if (value.isNull() || value.isMissingNode()) {
      return "not known";
    } else if (value.isContainerNode()) {
      List<String> texts = new ArrayList<>();
      value.elements().forEachRemaining(each -> texts.add(text(each)));
      return texts.isEmpty() ? "none" : String.join(", ", texts);
    } else if (value.isBoolean()) {
      return value.booleanValue() ? "yes" : "no";
    } else if (value.isFloatingPointNumber()) {
      return number(value.doubleValue());
    }
    return value.asText();
  }

  private static String number(double value) {
    double size = Math.abs(value);
    if (value == Math.rint(value) && size < 1e15) {
      return String.format(Locale.ROOT, "%.0f", value);
    }
    String shortest = Double.toString(value);
    return size > 1e-9 && size < 1e15 ? new BigDecimal(shortest).toPlainString() : shortest;
  }

  /** {@code maxRate} as {@code max rate}. */
  static String words(String name) {
    return name.matches("[a-z]+(?:[A-Z][a-z0-9]+)+")
        ? name.replaceAll("([A-Z])", " $1").toLowerCase(Locale.ROOT)
        : name;
  }
}
