package org.dfra.authority.cli;

import java.util.List;
import java.util.concurrent.Callable;
import org.dfra.authority.Authority;
import org.dfra.authority.IssuedCertificate;
import org.dfra.cli.team.PhoenixOptions.StateOption;
import org.dfra.core.host.CommandName;
import org.dfra.report.terminal.CommandFailure;
import org.dfra.report.terminal.ExitCode;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;

/** {@code ./dfra security renew}. */
@Command(
    name = "renew",
    description = "Issues a member a new certificate before or after its present one expires.",
    footer = {
      "",
      "The present certificate stays valid until it expires. On the member's computer, join",
      "the new bundle."
    })
final class RenewCommand implements Callable<Integer> {

  @Mixin
  @SuppressWarnings("NullAway.Init") // set by picocli before the call
  private MemberArgument member;

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
    try (Authority authority = authorities.open(state.folder())) {
      List<IssuedCertificate> all = authority.issued();
      String role = member.role(all);
      boolean isRevoked =
          all.stream()
              .filter(each -> each.name().equals(member.name()) && each.role().equals(role))
              .reduce((former, latter) -> latter)
              .flatMap(IssuedCertificate::revokedAt)
              .isPresent();
      if (isRevoked) {
        throw new CommandFailure(
            ExitCode.FAILED,
            role
                + " "
                + member.name()
                + " is revoked; to admit it again, type: "
                + CommandName.current()
                + " security issue "
                + role
                + " "
                + member.name());
      }
      options.issue(authority, role, member.name());
    }
    return ExitCode.SUCCESS;
  }
}
