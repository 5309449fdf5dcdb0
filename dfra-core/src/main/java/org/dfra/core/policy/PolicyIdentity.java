package org.dfra.core.policy;

/**
 * Which policy it is.
 *
 * @param team the team that it is for
 * @param version of two policies of a team, the later one has the higher version
 * @param digest SHA-256 of its text, as hexadecimal digits
 */
record PolicyIdentity(String team, long version, String digest) {

  /**
   * Checks that another policy may replace this one.
   *
   * @param file of the other one, for the message
   * @return false if they are the same
   * @throws PolicyReplacementException if it may not
   */
  boolean isReplacedBy(PolicyIdentity next, String file) {
    if (!next.team.equals(team)) {
      throw new PolicyReplacementException(
          file
              + ": the policy is of team "
              + next.team
              + ", and the present one of team "
              + team
              + "; sign one for this team");
    }
    if (next.version == version && next.digest.equals(digest)) {
      return false;
    }
    if (next.version <= version) {
      throw new PolicyReplacementException(
          file
              + ": the policy has version "
              + next.version
              + " and differs from the present one, which has version "
              + version
              + "; give it version "
              + (version + 1)
              + " or higher, and sign it again");
    }
    return true;
  }
}
