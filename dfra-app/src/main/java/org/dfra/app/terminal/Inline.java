package org.dfra.app.terminal;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.ArrayList;
import java.util.List;

/** Any value on one line, for people: {@code mode FIX_3D, satellites tracked 9}. */
public final class Inline {

  private Inline() {}

  /** What is not known is left out. */
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
                  parts.add(Outline.words(each.getKey()) + " " + inner(each.getValue()));
                }
              });
      return String.join(", ", parts);
    } else if (node.isArray() && !Outline.isLong(node)) {
      List<String> parts = new ArrayList<>();
      node.elements().forEachRemaining(each -> parts.add(inner(each)));
      return String.join(" ", parts);
    }
    return Outline.text(node);
  }

  private static String inner(JsonNode node) {
    return node.isObject() ? "(" + text(node) + ")" : text(node);
  }

  private static boolean isKnown(JsonNode node) {
    return !node.isNull() && !(node.isContainerNode() && node.isEmpty());
  }
}
