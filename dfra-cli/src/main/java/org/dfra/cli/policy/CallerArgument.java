package org.dfra.cli.policy;

import java.util.List;
import java.util.Optional;
import org.dfra.report.terminal.CommandFailure;
import org.dfra.report.terminal.ExitCode;
import org.dfra.security.Caller;
import org.dfra.security.Caller.Standing;
import org.dfra.security.Member;
import org.dfra.security.MemberRole;

/** Parses a caller: {@code operator anna}, {@code expired robot atrv1}, {@code stranger}. */
final class CallerArgument {

  private static final String EXPIRED = "expired";

  private CallerArgument() {}

  /**
   * The caller.
   *
   * @param team of members
   * @param robot whose own processes "own" means; empty for a robot without a name
   * @throws CommandFailure if the text is no caller
   */
  static Caller parse(String text, String team, String robot) {
    List<String> words = List.of(text.strip().split("\\s+"));
    if (words.equals(List.of("stranger"))) {
      return Caller.stranger("");
    } else if (words.equals(List.of("own"))) {
      return member(Standing.OWN, team, MemberRole.ROBOT, robot.isEmpty() ? "robot" : robot);
    }
    boolean isExpired = words.get(0).equals(EXPIRED);
    List<String> named = isExpired ? words.subList(1, words.size()) : words;
    try {
      if (named.size() == 2) {
        Standing standing = isExpired ? Standing.EXPIRED : Standing.MEMBER;
        return member(standing, team, MemberRole.of(named.get(0)), named.get(1));
      }
    } catch (IllegalArgumentException e) {
      throw new CommandFailure(ExitCode.USAGE_ERROR, "--who: " + e.getMessage(), e);
    }
    throw new CommandFailure(
        ExitCode.USAGE_ERROR,
        "--who \""
            + text
            + "\" is no caller; write a role and a name, such as \"operator anna\", with expired"
            + " before them if the certificate has expired, or stranger, or own");
  }

  private static Caller member(Standing standing, String team, MemberRole role, String name) {
    return new Caller(standing, Optional.of(new Member(team, role, name)), "");
  }
}
