package org.dfra.authority.cli;

import java.util.List;
import java.util.stream.Collectors;
import org.dfra.authority.IssuedCertificate;
import org.dfra.core.host.CommandName;
import org.dfra.report.terminal.CommandFailure;
import org.dfra.report.terminal.ExitCode;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** The argument that names whose certificates are meant. A picocli mix-in. */
final class MemberArgument {

  @Parameters(paramLabel = "NAME", description = "Name of the member.")
  private String name = "";

  @Option(
      names = "--role",
      paramLabel = "ROLE",
      description =
          "Its role, if members of several roles have this name: robot, operator, observer, code.")
  private @Nullable IssuedRole role;

  /** Its name. */
  String name() {
    return name;
  }

  /**
   * Its role.
   *
   * @param all that the authority has issued
   * @throws CommandFailure if there is no such member, or there are several
   */
  String role(List<IssuedCertificate> all) {
    List<String> roles =
        all.stream()
            .filter(each -> each.name().equals(name))
            .map(IssuedCertificate::role)
            .filter(each -> role == null || each.equals(role.text()))
            .distinct()
            .toList();
    if (roles.size() == 1) {
      return roles.get(0);
    }
    throw new CommandFailure(
        ExitCode.NOT_FOUND,
        roles.isEmpty()
            ? "the authority has issued no certificate to "
                + (role == null ? "" : role.text() + " ")
                + name
                + "; "
                + CommandName.current()
                + " security list shows all"
            : "there are "
                + roles.stream().map(each -> each + " " + name).collect(Collectors.joining(", "))
                + "; say which with --role");
  }
}
