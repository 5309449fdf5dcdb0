package org.dfra.security;

import java.util.Arrays;
import java.util.Locale;

/** What a member of a team is. Its certificate names it as organizational unit. */
public enum MemberRole {
  /** A robot: all its processes. */
  ROBOT,
  /** A person or program that may command and administer robots. */
  OPERATOR,
  /** A person or program that may look and listen. */
  OBSERVER;

  /** The role in certificates and policies, such as {@code robot}. */
  public String text() {
    return name().toLowerCase(Locale.ROOT);
  }

  /**
   * Parses {@link #text()}.
   *
   * @throws IllegalArgumentException if it is no role; the message names those that exist
   */
  public static MemberRole of(String text) {
    return Arrays.stream(values())
        .filter(each -> each.text().equals(text))
        .findFirst()
        .orElseThrow(
            () ->
                new IllegalArgumentException(
                    "role \"" + text + "\" is none of robot, operator, observer"));
  }
}
