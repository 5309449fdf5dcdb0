package org.dfra.authority.cli;

import java.util.concurrent.Callable;
import org.dfra.authority.Authority;
import org.dfra.cli.team.PhoenixOptions.StateOption;
import org.dfra.report.terminal.ExitCode;
import org.dfra.security.Member;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Parameters;

/** {@code ./dfra security issue}. */
@Command(
    name = "issue",
    description = "Admits a member to the team: issues its certificate, in a bundle.",
    footer = {
      "",
      "Carry the bundle to the member's computer, and give the passphrase by another way. The",
      "name of a robot is the name in its XML. The role code is for a key that signs code: it",
      "is in PKCS #12, and no bundle of a member."
    })
final class IssueCommand implements Callable<Integer> {

  @Parameters(
      index = "0",
      paramLabel = "ROLE",
      description = "robot, operator or observer; or code, for a key that signs code.")
  @SuppressWarnings("NullAway.Init") // set by picocli before the call
  private IssuedRole role;

  @Parameters(
      index = "1",
      paramLabel = "NAME",
      description = "Name of the member: " + Member.NAME_RULE + ".")
  private String name = "";

  @Mixin
  @SuppressWarnings("NullAway.Init") // set by picocli before the call
  private IssueOptions options;

  @Mixin
  @SuppressWarnings("NullAway.Init") // set by picocli before the call
  private AuthorityOptions authorities;

  @Mixin
  @SuppressWarnings("NullAway.Init") // set by picocli before the call
  private StateOption state;

  @Override
  public Integer call() throws Exception {
    options.requireName(name);
    try (Authority authority = authorities.open(state.folder())) {
      options.issue(authority, role.text(), name);
    }
    return ExitCode.SUCCESS;
  }
}
