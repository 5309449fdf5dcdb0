package org.dfra.authority.cli;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Callable;
import org.dfra.authority.Authority;
import org.dfra.authority.cli.Publication.RobotView;
import org.dfra.cli.team.TeamOptions;
import org.dfra.core.policy.Policy;
import org.dfra.core.policy.PolicyBundle;
import org.dfra.core.policy.PolicyReplacementException;
import org.dfra.report.terminal.CommandFailure;
import org.dfra.report.terminal.ExitCode;
import org.dfra.river.identity.SecurityFiles;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;

/** {@code ./dfra security publish}. */
@Command(
    name = "publish",
    description = "Signs the policy of the authority, and gives it to every robot that is found.",
    footer = {
      "",
      "Edit policy.xml in the folder of the authority and raise its version first. This",
      "computer's identity and the robots get the policy and the present list of revoked",
      "certificates. A robot that is not found gets them later from another member.",
      "Exits with 1 if a robot that was found does not have them in force."
    })
final class PublishCommand implements Callable<Integer> {

  @Mixin
  @SuppressWarnings("NullAway.Init") // set by picocli before the call
  private AuthorityOptions authorities;

  @Mixin
  @SuppressWarnings("NullAway.Init") // set by picocli before the call
  private TeamOptions team;

  /** What is printed. */
  private record PublishView(String policy, long version, List<RobotView> robots) {}

  @Override
  public Integer call() throws Exception {
    try (Publication publication = Publication.begin(team);
        Authority authority = authorities.open(team.state())) {
      String file = authorities.folder(team.state()).resolve(SecurityFiles.POLICY).toString();
      PolicyBundle signed =
          authority
              .policy()
              .orElseThrow(() -> new CommandFailure(ExitCode.FAILED, "there is no policy " + file));
      OwnIdentity own =
          OwnIdentity.in(team.state(), authority)
              .orElseThrow(
                  () ->
                      new CommandFailure(
                          ExitCode.FAILED,
                          "this computer has no identity of team "
                              + authority.team()
                              + " from which robots could take the policy; join the team here"
                              + " first, or renew each robot and join the bundle there"));
      Policy policy = take(own, signed, file);
      own.takeRevocations();
      List<String> lines = new ArrayList<>();
      lines.add("Signed " + policy + ": " + file);
      List<RobotView> robots = publication.run();
      lines.addAll(Publication.sentences(publication.isPossible(), robots));
      team.answer().lines(new PublishView(file, policy.version(), robots), lines);
      return robots.stream().allMatch(RobotView::isInForce) ? ExitCode.SUCCESS : ExitCode.FAILED;
    }
  }

  private static Policy take(OwnIdentity own, PolicyBundle signed, String file) throws Exception {
    try {
      return own.takePolicy(signed);
    } catch (PolicyReplacementException e) {
      throw new CommandFailure(
          ExitCode.FAILED,
          Optional.ofNullable(e.getMessage()).orElse(file) + "; raise the version in " + file);
    }
  }
}
