package org.dfra.core.config;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Function;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.jspecify.annotations.Nullable;

/**
 * Substitutes variables by their values.
 *
 * <p>{@code ${NAME}} is the value of NAME, which must be set. {@code ${NAME:-default}} is the
 * default if NAME is not set or empty, as in a POSIX shell; the default may contain variables
 * itself, but no other closing brace. {@code $$} is a dollar.
 */
public final class Substitution {

  private static final Pattern NAME = Pattern.compile("[A-Za-z_][A-Za-z0-9_.]*");

  private final Function<String, @Nullable String> lookup;
  private final ConfigurationFaults faults;

  /**
   * @param lookup returns the value of a variable, or null if it is not set
   */
  public Substitution(Function<String, @Nullable String> lookup, ConfigurationFaults faults) {
    this.lookup = lookup;
    this.faults = faults;
  }

  /** The system property of that name, else the environment variable; null if neither is set. */
  public static @Nullable String environment(String name) {
    String property = System.getProperty(name);
    return property != null ? property : System.getenv(name);
  }

  /** Escapes a text so that {@link #apply} returns the original. */
  public static String escape(String text) {
    return text.replace("$", "$$");
  }

  /** The text with its variables substituted; null, with a recorded fault, if that fails. */
  @Nullable String apply(String text, SourceLocation place) {
    Scan scan = new Scan(text);
    String result = scan.text(false);
    scan.complaints.forEach(complaint -> faults.add(place, complaint));
    return scan.complaints.isEmpty() ? result : null;
  }

  /** One pass over one text, by recursive descent. */
  private final class Scan {
    private final String text;
    private final List<String> complaints = new ArrayList<>();
    private int next;

    Scan(String text) {
      this.text = text;
    }

    /** Up to the end, or up to the brace that closes a default. */
    String text(boolean inDefault) {
      StringBuilder result = new StringBuilder();
      while (next < text.length() && !(inDefault && text.charAt(next) == '}')) {
        if (taken("$$")) {
          result.append('$');
        } else if (taken("${")) {
          result.append(variable(next - 2));
        } else if (text.charAt(next) == '$') {
          complain("the dollar in \"" + text + "\" begins no variable", "$$ for a dollar itself");
        } else {
          result.append(text.charAt(next++));
        }
      }
      return result.toString();
    }

    private String variable(int start) {
      Matcher name = NAME.matcher(text).region(next, text.length());
      if (!name.lookingAt()) {
        return complain("\"" + text.substring(start) + "\" names no variable", "$$ for a dollar");
      }
      next = name.end();
      String value = lookup.apply(name.group());
      if (taken("}")) {
        return value == null ? unset(name.group()) : value;
      }
      if (!taken(":-")) {
        return complain("\"" + text.substring(start) + "\" is not a variable", "$$ for a dollar");
      }
      int before = complaints.size();
      String otherwise = text(true);
      if (!taken("}")) {
        return complaints.size() > before
            ? ""
            : complain(
                "\"" + text.substring(start) + "\" lacks its closing brace", "$$ for a dollar");
      }
      if (value == null || value.isEmpty()) {
        return otherwise;
      }
      complaints.subList(before, complaints.size()).clear(); // of a default that is not needed
      return value;
    }

    private String unset(String name) {
      complaints.add(
          "the variable "
              + name
              + " is not set; set it in the environment, or write ${"
              + name
              + ":-default}");
      return "";
    }

    private String complain(String what, String dollar) {
      complaints.add(what + "; write ${NAME}, ${NAME:-default} or " + dollar);
      next = text.length();
      return "";
    }

    private boolean taken(String token) {
      boolean taken = text.startsWith(token, next);
      next += taken ? token.length() : 0;
      return taken;
    }
  }
}
