package org.dfra.river.security.robot;

import java.io.Serializable;
import java.time.Instant;
import java.util.regex.Pattern;

/**
 * A fact that somebody has set on a robot, for {@code <while>} in policies.
 *
 * @param name such as {@code load}
 * @param value such as {@code none}
 * @param set when, by the robot's clock
 * @param by who has set it
 */
public record NamedFact(String name, String value, Instant set, String by) implements Serializable {

  /** The longest value, in characters. */
  public static final int MAX_VALUE = 64;

  private static final Pattern NAME = Pattern.compile("[a-z][a-z0-9_.-]{0,63}");
  private static final Pattern VALUE =
      Pattern.compile("[\\x21-\\x7e]([\\x20-\\x7e]*[\\x21-\\x7e])?");

  /** Checks it. */
  public NamedFact {
    requireName(name);
    if (value.length() > MAX_VALUE || !VALUE.matcher(value).matches()) {
      throw new IllegalArgumentException(
          "\"" + value + "\" is no value of a fact; write 1 to " + MAX_VALUE + " ASCII characters");
    }
  }

  /**
   * Checks a name.
   *
   * @return the name
   * @throws IllegalArgumentException if no fact can have it
   */
  public static String requireName(String name) {
    if (!NAME.matcher(name).matches()) {
      throw new IllegalArgumentException(
          "\"" + name + "\" is no name of a fact; write it in lower case, such as load");
    }
    return name;
  }
}
