package org.dfra.directory;

import java.util.List;
import java.util.stream.Collectors;

/** How names and values are written in a query's words. */
final class QueryFormatter {

  private static final String PLAIN = "[\\w./-]+";

  private QueryFormatter() {}

  /** A name as it is, or in quotation marks where it would not be read as one word. */
  static String name(String name) {
    return name.matches(PLAIN) ? name : quoted(name);
  }

  static String quoted(String text) {
    return '"' + text.replace("\\", "\\\\").replace("\"", "\\\"") + '"';
  }

  /** A component's value: texts in quotation marks, lists in brackets. */
  static String value(Object value) {
    if (value instanceof String text) {
      return quoted(text);
    } else if (value instanceof List<?> list) {
      return list.stream().map(QueryFormatter::value).collect(Collectors.joining(", ", "[", "]"));
    }
    return value instanceof Enum<?> constant ? constant.name() : value.toString();
  }
}
