package org.dfra.core.policy;

import java.util.Arrays;
import java.util.List;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import org.jspecify.annotations.Nullable;

/** Names, separated by commas; {@code *} in one stands for any letters. */
final class NamePattern {

  /** Matches every name. */
  static final NamePattern ANY = new NamePattern("");

  private static final Pattern ITEM = Pattern.compile("[A-Za-z0-9._*-]{1,64}");
  private static final Pattern NAME = Pattern.compile("[A-Za-z0-9._-]{1,64}");
  private static final int MAX_STARS = 4;

  private final String text;
  private final List<Pattern> patterns;

  private NamePattern(String text) {
    this.text = text;
    this.patterns = items(text).stream().map(NamePattern::compile).toList();
  }

  /**
   * @param text without a {@link #fault}
   */
  static NamePattern of(String text) {
    return new NamePattern(text);
  }

  /** What is wrong with the name of a rule or a region, and the remedy; null if nothing. */
  static @Nullable String nameFault(String name) {
    return NAME.matcher(name).matches()
        ? null
        : "\""
            + name
            + "\" is no name; write at most 64 letters, digits, dots, hyphens, underscores";
  }

  /** What is wrong with a text, and the remedy; null if it is names. */
  static @Nullable String fault(String text) {
    List<String> items = items(text);
    if (items.isEmpty()) {
      return "names nothing; write a name, or several with commas between them";
    }
    return items.stream()
        .filter(each -> !ITEM.matcher(each).matches() || stars(each) > MAX_STARS)
        .findFirst()
        .map(
            each ->
                "\""
                    + each
                    + "\" is no name; write at most 64 letters, digits, dots, hyphens,"
                    + " underscores, and at most "
                    + MAX_STARS
                    + " stars")
        .orElse(null);
  }

  private static long stars(String item) {
    return item.chars().filter(c -> c == '*').count();
  }

  /** The items between the commas of a text; blank ones are omitted. */
  static List<String> items(String text) {
    return Arrays.stream(text.split(",")).map(String::strip).filter(s -> !s.isEmpty()).toList();
  }

  private static Pattern compile(String item) {
    return Pattern.compile(
        Arrays.stream(item.split("\\*", -1)).map(Pattern::quote).collect(Collectors.joining(".*")));
  }

  boolean isAny() {
    return patterns.isEmpty();
  }

  /**
   * Whether a name is one of them. An empty name belongs to nothing, and only {@link #ANY} has it.
   */
  boolean matches(String name) {
    return isAny()
        || (!name.isEmpty() && patterns.stream().anyMatch(each -> each.matcher(name).matches()));
  }

  @Override
  public String toString() {
    return text;
  }
}
