package org.dfra.cli.security;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Instant;
import java.util.List;
import java.util.concurrent.Callable;
import org.dfra.cli.team.PhoenixOptions.StateOption;
import org.dfra.core.host.CommandName;
import org.dfra.core.host.PrivateFiles;
import org.dfra.report.terminal.CommandOutput;
import org.dfra.report.terminal.ExitCode;
import org.dfra.river.access.CallCredential;
import org.dfra.river.identity.Delegation;
import org.dfra.river.identity.IdentityException;
import org.dfra.river.identity.IdentityFolder;
import org.dfra.river.identity.SecurityFiles;
import org.dfra.river.identity.StoredDelegations;
import org.dfra.river.identity.StoredDelegations.Filed;
import org.dfra.river.identity.TeamCertificates;
import org.dfra.river.identity.TeamCredentials;
import org.dfra.security.Member;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Parameters;

/** {@code ./dfra security accept}. */
@Command(
    name = "accept",
    description = "Takes what an operator has delegated to this computer's member.",
    footer = {
      "",
      "From then on this member's commands to the robots that the operator has named are made",
      "on the operator's behalf, those of processes that run already too. A later one of the",
      "same operator replaces it. To end it, delete the file that this command names."
    })
final class AcceptCommand implements Callable<Integer> {

  @Parameters(
      paramLabel = "FILE",
      description = "The file that " + CommandName.IN_HELP + " security delegate has written.")
  @SuppressWarnings("NullAway.Init") // set by picocli before the call
  private Path file;

  @Mixin
  @SuppressWarnings("NullAway.Init") // set by picocli before the call
  private StateOption state;

  @Mixin
  @SuppressWarnings("NullAway.Init") // set by picocli before the call
  private CommandOutput answer;

  @Override
  public Integer call() throws Exception {
    Path folder = state.folder().resolve(SecurityFiles.FOLDER);
    TeamCredentials own = IdentityFolder.load(folder);
    Delegation read = read();
    Instant now = Instant.now();
    requireUsable(read, own, now);
    Path stored = folder.resolve(StoredDelegations.fileName(read.principal()));
    PrivateFiles.write(stored, read.text().getBytes(StandardCharsets.US_ASCII));
    deleteExpired(folder, own, now);
    DelegationView view = DelegationView.of(read, now);
    answer.lines(view, List.of(view.line(), "To end it, delete " + stored + "."));
    return ExitCode.SUCCESS;
  }

  private Delegation read() throws IdentityException {
    if (!Files.exists(file)) {
      throw new IdentityException("there is no file " + file + "; name the operator's");
    }
    try (var in = Files.newInputStream(file)) {
      return Delegation.parse(in.readNBytes(CallCredential.MAX_BYTES + 1), file.toString());
    } catch (IOException e) {
      throw new IdentityException(file + " cannot be read (" + e + ")", e);
    }
  }

  private void requireUsable(Delegation read, TeamCredentials own, Instant now)
      throws IdentityException {
    if (!read.bearer().equals(own.member())) {
      throw new IdentityException(
          file + " is for " + read.bearer() + ", and this computer is " + own.member());
    } else if (!read.fingerprint().equals(Delegation.fingerprint(own.certificate()))) {
      throw new IdentityException(
          file
              + " names another certificate of "
              + own.member()
              + " than this computer has; ask for a new one with the fingerprint that "
              + CommandName.current()
              + " whoami shows");
    } else if (now.isAfter(read.until())) {
      throw new IdentityException(file + " has expired at " + read.until() + "; ask for a new one");
    }
    Member unused =
        TeamCertificates.member(List.of(read.certificate()), own.authority(), file.toString());
    boolean isRevoked =
        own.revocations().map(list -> list.isRevoked(read.certificate())).orElse(false);
    if (isRevoked) {
      throw new IdentityException("the certificate of " + read.principal() + " is revoked");
    }
  }

  private static void deleteExpired(Path folder, TeamCredentials own, Instant now)
      throws IOException, IdentityException {
    for (Filed each : StoredDelegations.list(folder, own)) {
      @Nullable Delegation delegation = each.delegation();
      if (delegation != null && now.isAfter(delegation.until())) {
        boolean unused = Files.deleteIfExists(each.file());
      }
    }
  }
}
