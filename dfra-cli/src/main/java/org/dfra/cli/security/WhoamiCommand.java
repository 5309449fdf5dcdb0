package org.dfra.cli.security;

import java.nio.file.Path;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.Callable;
import org.dfra.cli.team.PhoenixOptions.StateOption;
import org.dfra.report.terminal.CommandOutput;
import org.dfra.report.terminal.ExitCode;
import org.dfra.river.identity.IdentityFolder;
import org.dfra.river.identity.SecurityFiles;
import org.dfra.river.identity.StoredDelegations;
import org.dfra.river.identity.TeamCredentials;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;

/** {@code ./dfra whoami}. */
@Command(
    name = "whoami",
    description = "Shows which member of a team the commands of this computer are.",
    footer = {
      "",
      "Exits with 1 if this computer has joined a team and its identity cannot be read."
    })
public final class WhoamiCommand implements Callable<Integer> {

  @Mixin
  @SuppressWarnings("NullAway.Init") // set by picocli before the call
  private StateOption state;

  @Mixin
  @SuppressWarnings("NullAway.Init") // set by picocli before the call
  private CommandOutput answer;

  @Override
  public Integer call() throws Exception {
    Path folder = state.folder().resolve(SecurityFiles.FOLDER);
    if (!IdentityFolder.isJoined(folder)) {
      answer.sentence(
          Map.of("member", "none"),
          "Nobody: this computer has joined no team, so its commands prove no identity (open"
              + " mode).");
      return ExitCode.SUCCESS;
    }
    TeamCredentials credentials = IdentityFolder.load(folder);
    Instant now = Instant.now();
    MemberView view =
        MemberView.of(
            credentials, Optional.empty(), StoredDelegations.list(folder, credentials), now);
    List<String> lines = new ArrayList<>();
    lines.add(
        "The "
            + view.member()
            + ", valid until "
            + view.validUntil()
            + (view.state().equals("valid") ? "." : ": " + view.state() + "."));
    lines.add("Fingerprint of the certificate: " + view.fingerprint());
    credentials.validityFault(now).ifPresent(fault -> lines.add("Note: " + fault + "."));
    lines.addAll(view.delegations());
    answer.lines(view, lines);
    return ExitCode.SUCCESS;
  }
}
