package org.dfra.core.policy;

import java.util.List;
import org.dfra.core.config.SourceLocation;

/**
 * Who may do what with the robots of a team. The first rule that matches a call decides; a call
 * that no rule matches is refused. Immutable.
 *
 * @param team the team whose members it is about; members of other teams are strangers
 * @param version 0 or more; a later policy has a higher one
 * @param rules about calls, in their order
 * @param visibility rules about what lookup services show, in their order; what none matches is
 *     shown
 * @param digest SHA-256 of the text that it was read from, as hexadecimal digits: two policies with
 *     the same digest are the same
 * @param place its file
 */
public record Policy(
    String team,
    long version,
    List<PolicyRule> rules,
    List<VisibilityRule> visibility,
    String digest,
    SourceLocation place) {

  /** The name of the decision about calls that no rule matches. */
  public static final String DEFAULT_RULE = "default";

  /** Copies the lists. */
  public Policy {
    rules = List.copyOf(rules);
    visibility = List.copyOf(visibility);
  }

  /** Which policy it is. */
  PolicyIdentity identity() {
    return new PolicyIdentity(team, version, digest);
  }

  /** As in sentences, such as {@code policy 7 of field}. */
  @Override
  public String toString() {
    return "policy " + version + " of " + team;
  }
}
