package org.dfra.authority.cli;

import java.math.BigInteger;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Callable;
import org.dfra.authority.Authority;
import org.dfra.authority.IssuedCertificate;
import org.dfra.authority.cli.Publication.RobotView;
import org.dfra.cli.team.TeamOptions;
import org.dfra.report.terminal.ExitCode;
import org.dfra.river.identity.SecurityFiles;
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
      "and in this computer's identity if it is of the same team. Every robot that is found gets",
      "it at once, others from the next member that has it. Later bundles contain it.",
      "Exits with 1 if a robot that was found does not have it in force.",
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
  private TeamOptions team;

  @Spec
  @SuppressWarnings("NullAway.Init") // set by picocli before the call
  private CommandSpec spec;

  /** What is printed. */
  private record RevokeView(
      List<IssuedCertificate> revoked, BigInteger list, String file, List<RobotView> robots) {}

  @Override
  public Integer call() throws Exception {
    if (reason.length() > MAX_REASON) {
      throw new ParameterException(
          spec.commandLine(),
          "--reason has " + reason.length() + " characters, at most " + MAX_REASON + " are kept");
    }
    try (Publication publication = Publication.begin(team);
        Authority authority = authorities.open(team.state())) {
      String role = member.role(authority.issued());
      List<IssuedCertificate> revoked =
          authority.revoke(
              each -> each.name().equals(member.name()) && each.role().equals(role), reason);
      Path file = authorities.folder(team.state()).resolve(SecurityFiles.REVOKED);
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
      Optional<OwnIdentity> own = OwnIdentity.in(team.state(), authority);
      List<RobotView> robots = List.of();
      if (own.isPresent()) {
        own.get().takeRevocations();
        lines.add("This computer's identity has it too.");
        robots = publication.run();
      }
      lines.addAll(Publication.sentences(own.isPresent() && publication.isPossible(), robots));
      team.answer()
          .lines(
              new RevokeView(revoked, authority.revocationNumber(), file.toString(), robots),
              lines);
      return robots.stream().allMatch(RobotView::isInForce) ? ExitCode.SUCCESS : ExitCode.FAILED;
    }
  }
}
