package org.dfra.report.terminal;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.DoubleNode;
import java.math.BigDecimal;
import java.math.MathContext;
import java.math.RoundingMode;
import java.util.ArrayList;
import java.util.List;

/**
 * Any value on one line, for text output: {@code mode FIX_3D, satellites tracked 9}. Numbers have
 * seven decimals, of which the last one is about 0.01 m in a latitude, or more if they are small;
 * JSON output has full precision.
 */
public final class InlineFormat {

  private static final int DECIMALS = 7;
  private static final MathContext SMALL = new MathContext(4);

  private InlineFormat() {}

  /** Omits unknown values. */
  public static String of(Object value) {
    return text(Json.tree(value));
  }

  private static String text(JsonNode node) {
    if (node.isObject()) {
      List<String> parts = new ArrayList<>();
      node.properties()
          .forEach(
              each -> {
                if (isKnown(each.getValue())) {
                  parts.add(IndentedFormat.words(each.getKey()) + " " + inner(each.getValue()));
                }
              });
      return String.join(", ", parts);
    } else if (node.isArray() && !IndentedFormat.isLong(node)) {
      List<String> parts = new ArrayList<>();
      node.elements().forEachRemaining(each -> parts.add(inner(each)));
      return String.join(" ", parts);
    }
    return node.isFloatingPointNumber()
        ? IndentedFormat.text(shortened(node))
        : IndentedFormat.text(node);
  }

  private static JsonNode shortened(JsonNode number) {
    double value = number.doubleValue();
    if (!Double.isFinite(value)) {
      return number;
    }
    BigDecimal exact = BigDecimal.valueOf(value);
    BigDecimal cut = exact.setScale(DECIMALS, RoundingMode.HALF_EVEN);
    BigDecimal small = exact.round(SMALL);
    return DoubleNode.valueOf((small.scale() > DECIMALS ? small : cut).doubleValue());
  }

  private static String inner(JsonNode node) {
    return node.isObject() ? "(" + text(node) + ")" : text(node);
  }

  private static boolean isKnown(JsonNode node) {
    return !node.isNull() && !(node.isContainerNode() && node.isEmpty());
  }
}
