package org.dfra.authority.cli;

import java.io.IOException;
import java.math.BigInteger;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.Callable;
import org.dfra.authority.Authority;
import org.dfra.authority.IssuedCertificate;
import org.dfra.core.host.PrivateFiles;
import org.dfra.report.terminal.CommandOutput;
import org.dfra.report.terminal.ExitCode;
import org.dfra.river.identity.IdentityException;
import org.dfra.river.identity.SecurityFiles;
import org.dfra.river.identity.TeamCertificates;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;

/** {@code ./dfra security revoke}. */
@Command(
    name = "revoke",
    description = "Ends the membership of a member: revokes all its certificates.",
    footer = {
      "",
      "Writes the next list of revoked certificates: revoked.crl in the folder of the authority,",
      "and in this computer's identity if it is of the same team. Later bundles contain it.",
      "A revoked member can be admitted again by a new certificate."
    })
final class RevokeCommand implements Callable<Integer> {

  private static final int MAX_REASON = 200;

  @Mixin
  @SuppressWarnings("NullAway.Init") // set by picocli before the call
  private MemberArgument member;

  @Option(
      names = "--reason",
      paramLabel = "TEXT",
      description = "Why, for the authority's register (default \"${DEFAULT-VALUE}\").")
  private String reason = "no reason given";

  @Mixin
  @SuppressWarnings("NullAway.Init") // set by picocli before the call
  private AuthorityOptions authorities;

  @Mixin
  @SuppressWarnings("NullAway.Init") // set by picocli before the call
  private CommandOutput answer;

  @Spec
  @SuppressWarnings("NullAway.Init") // set by picocli before the call
  private CommandSpec spec;

  /** What is printed. */
  private record RevokeView(List<IssuedCertificate> revoked, BigInteger list, String file) {}

  @Override
  public Integer call() throws Exception {
    if (reason.length() > MAX_REASON) {
      throw new ParameterException(
          spec.commandLine(),
          "--reason has " + reason.length() + " characters, at most " + MAX_REASON + " are kept");
    }
    try (Authority authority = authorities.open()) {
      String role = member.role(authority.issued());
      List<IssuedCertificate> revoked =
          authority.revoke(
              each -> each.name().equals(member.name()) && each.role().equals(role), reason);
      Path file = authorities.folder().resolve(SecurityFiles.REVOKED);
      List<String> lines = new ArrayList<>();
      lines.add(
          revoked.isEmpty()
              ? "All certificates of " + role + " " + member.name() + " were revoked before."
              : "Revoked "
                  + role
                  + " "
                  + member.name()
                  + ": "
                  + revoked.size()
                  + (revoked.size() == 1 ? " certificate." : " certificates."));
      lines.add("List " + authority.revocationNumber() + " is " + file + ".");
      if (updateOwnIdentity(authority)) {
        lines.add("This computer's identity has it too.");
      }
      answer.lines(new RevokeView(revoked, authority.revocationNumber(), file.toString()), lines);
    }
    return ExitCode.SUCCESS;
  }

  /** Gives the list to the identity of this computer. */
  private boolean updateOwnIdentity(Authority authority) throws IOException, IdentityException {
    Path own = authorities.state().resolve(SecurityFiles.FOLDER);
    Path certificate = own.resolve(SecurityFiles.AUTHORITY);
    if (!Files.exists(certificate)) {
      return false;
    }
    boolean isSameTeam =
        TeamCertificates.authority(Files.readAllBytes(certificate), certificate.toString())
            .equals(authority.certificate());
    Path list = own.resolve(SecurityFiles.REVOKED);
    boolean isNew =
        !Files.exists(list) || !Arrays.equals(Files.readAllBytes(list), authority.revocations());
    if (isSameTeam && isNew) {
      PrivateFiles.write(list, authority.revocations());
    }
    return isSameTeam;
  }
}
