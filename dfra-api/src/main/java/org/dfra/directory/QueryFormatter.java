package org.dfra.directory;

import java.util.List;
import java.util.stream.Collectors;

/** Formats names and values in a query's text. */
final class QueryFormatter {

  private static final String PLAIN = "[\\w./-]+";

  private QueryFormatter() {}

  /** The name, in quotation marks if the parser would not read it as one word. */
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
