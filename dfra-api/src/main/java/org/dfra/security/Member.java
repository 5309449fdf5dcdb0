package org.dfra.security;

import java.io.Serializable;
import java.security.Principal;
import java.util.HashMap;
import java.util.Locale;
import java.util.Map;
import java.util.regex.Pattern;
import javax.naming.InvalidNameException;
import javax.naming.ldap.LdapName;
import javax.naming.ldap.Rdn;
import javax.security.auth.x500.X500Principal;

/**
 * A member of a team: a robot, an operator or an observer. The subject of its certificate is {@code
 * CN=name, OU=role, O=team}.
 *
 * @param team name of the team, which its authority has given it
 * @param role what it is
 * @param name its name, unique among the members of its role; that of a robot is the name in its
 *     XML
 */
public record Member(String team, MemberRole role, String name) implements Principal, Serializable {

  private static final long serialVersionUID = 1L;

  /** What a name or a team may be. */
  public static final String NAME_RULE =
      "1 to 64 letters, digits, dots, hyphens and underscores, the first a letter or digit";

  /** {@link #NAME_RULE} as a regular expression. */
  public static final String NAME_FORM = "[A-Za-z0-9][A-Za-z0-9._-]{0,63}";

  private static final Pattern NAME = Pattern.compile(NAME_FORM);

  /**
   * Checks them.
   *
   * @throws IllegalArgumentException if a name breaks {@link #NAME_RULE}
   */
  public Member {
    requireName("team", team);
    requireName("name", name);
    if (role == null) {
      throw new IllegalArgumentException("a member without a role");
    }
  }

  private static void requireName(String what, String text) {
    if (!NAME.matcher(text).matches()) {
      throw new IllegalArgumentException(what + " \"" + text + "\" is not " + NAME_RULE);
    }
  }

  /**
   * The member that a certificate's subject names.
   *
   * @throws IllegalArgumentException if it names none; the message says why
   */
  public static Member of(X500Principal subject) {
    Map<String, String> parts = new HashMap<>();
    try {
      for (Rdn each : new LdapName(subject.getName()).getRdns()) {
        String type = each.getType().toUpperCase(Locale.ROOT);
        if (each.size() != 1 || parts.put(type, String.valueOf(each.getValue())) != null) {
          throw new IllegalArgumentException(subject + " has several values of " + type);
        }
      }
    } catch (InvalidNameException e) {
      throw new IllegalArgumentException(subject + " is no name of a member", e);
    }
    String name = parts.getOrDefault("CN", "");
    String role = parts.getOrDefault("OU", "");
    String team = parts.getOrDefault("O", "");
    if (parts.size() != 3 || name.isEmpty() || role.isEmpty() || team.isEmpty()) {
      throw new IllegalArgumentException(
          "\"" + subject + "\" is no member: its name is not CN=name, OU=role, O=team");
    }
    return new Member(team, MemberRole.of(role), name);
  }

  /** The subject of its certificate. */
  public X500Principal x500() {
    return new X500Principal("CN=" + name + ",OU=" + role.text() + ",O=" + team);
  }

  @Override
  public String getName() {
    return name;
  }

  /** As in sentences, such as {@code operator anna of field}. */
  @Override
  public String toString() {
    return role.text() + " " + name + " of " + team;
  }
}
