package org.dfra.core.policy;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import org.dfra.core.policy.method.InterfaceCatalogue;
import org.dfra.security.Member;
import org.dfra.security.MemberRole;

/**
 * The policies that DFRA brings. Their version is 0, so that each policy of a team replaces them.
 */
public final class BuiltInPolicies {

  private static final String WRITTEN = "team=\"field\" version=\"0\"";

  private BuiltInPolicies() {}

  /** The policy of a team that has none of its own. */
  public static Policy standard(String team) {
    return read("default-policy.xml", team);
  }

  /**
   * The policy of a robot without valid credentials or without a valid policy: only its own
   * processes may do anything; others may stop it, and renew and cancel leases that they have.
   */
  public static Policy closed(String team) {
    return read("closed-policy.xml", team);
  }

  /**
   * The text of {@link #standard}, from which a team writes a policy of its own.
   *
   * @param version that it gets
   * @throws IllegalArgumentException if the team's name is not {@link Member#NAME_RULE}
   */
  public static String standardText(String team, long version) {
    return text("default-policy.xml", team, version);
  }

  private static Policy read(String resource, String team) {
    byte[] text = text(resource, team, 0).getBytes(StandardCharsets.UTF_8);
    return PolicyXml.read(text, resource, InterfaceCatalogue.builtIn());
  }

  private static String text(String resource, String team, long version) {
    Member named = new Member(team, MemberRole.OPERATOR, "any"); // checks the name
    try (InputStream in = BuiltInPolicies.class.getResourceAsStream(resource)) {
      if (in == null) {
        throw new IOException("it is missing");
      }
      String written = new String(in.readAllBytes(), StandardCharsets.UTF_8);
      if (!written.contains(WRITTEN)) {
        throw new IOException("it lacks " + WRITTEN);
      }
      return written.replace(WRITTEN, "team=\"" + named.team() + "\" version=\"" + version + "\"");
    } catch (IOException e) {
      throw new IllegalStateException(resource + " of this jar is damaged; rebuild DFRA", e);
    }
  }
}
