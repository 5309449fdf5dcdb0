package org.dfra.core.config;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.jdom2.Namespace;

/**
 * Converts the messages of the JDK's schema validator into plain sentences.
 *
 * <p>Its messages begin with the violated rule of XML Schema 1.0 part 1, appendix C.1, e.g. {@code
 * cvc-complex-type.4:}, and quote names with apostrophes. Unknown messages are passed on without
 * the rule's name.
 */
final class SchemaErrorMessage {

  private static final Pattern RULE = Pattern.compile("(cvc-[A-Za-z0-9.-]+): (.*)", Pattern.DOTALL);
  private static final Pattern QUOTED = Pattern.compile("'([^']*)'");
  private static final Pattern PREFIX = Pattern.compile("\\{?\"[^\"]*\":|[{}]");

  private SchemaErrorMessage() {}

  /**
   * @param message the validator's message, in English
   * @param attributes all elements with their permitted attributes
   * @param namespace the namespace of these elements
   */
  static String of(String message, Map<String, List<String>> attributes, Namespace namespace) {
    Matcher matcher = RULE.matcher(message);
    if (!matcher.matches()) {
      return message;
    }
    List<String> quoted = new ArrayList<>();
    QUOTED.matcher(matcher.group(2)).results().forEach(result -> quoted.add(result.group(1)));
    String first = quoted.isEmpty() ? "" : plain(quoted.get(0));
    String second = quoted.size() < 2 ? "" : plain(quoted.get(1));
    return switch (matcher.group(1)) {
      case "cvc-complex-type.2.4.a", "cvc-complex-type.2.4.d" ->
          unknownElement(quoted.get(0), first, second, namespace);
      case "cvc-complex-type.3.2.2" ->
          unknownAttribute(first, second, attributes.getOrDefault(second, List.of()));
      case "cvc-complex-type.4" ->
          "<" + second + "> lacks its " + first + "; write " + first + "=\"…\" in it";
      case "cvc-complex-type.2.1" ->
          "<" + first + "> must be empty; delete what is between its two tags";
      case "cvc-complex-type.2.3" -> "<" + first + "> holds text beside its elements; delete it";
      case "cvc-type.3.1.1" -> "<" + first + "> takes no attribute; delete those it has";
      case "cvc-type.3.1.2" -> "<" + first + "> takes text only; delete the elements in it";
      default -> matcher.group(2);
    };
  }

  private static String unknownElement(
      String written, String name, String expected, Namespace namespace) {
    List<String> known = expected.isEmpty() ? List.of() : List.of(expected.split(", "));
    if (known.contains(name)) {
      return "<"
          + name
          + "> is not in the namespace "
          + namespace.getURI()
          + " but is written as "
          + written
          + "; delete its own xmlns";
    }
    return "<"
        + name
        + "> is not known here"
        + NearestName.hint(
            name,
            known,
            known.isEmpty() ? "; delete it" : "; write <" + String.join("> or <", known) + ">");
  }

  private static String unknownAttribute(String name, String element, List<String> known) {
    return "the attribute "
        + name
        + " is not known in <"
        + element
        + ">"
        + NearestName.hint(
            name, known, known.isEmpty() ? "; delete it" : "; write " + String.join(" or ", known));
  }

  /** The name, or the names between commas, without their namespaces. */
  private static String plain(String quoted) {
    return PREFIX.matcher(quoted).replaceAll("");
  }
}
