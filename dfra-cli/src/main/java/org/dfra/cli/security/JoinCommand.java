package org.dfra.cli.security;

import java.nio.file.Path;
import java.time.Instant;
import java.util.List;
import java.util.OptionalLong;
import java.util.concurrent.Callable;
import org.dfra.cli.team.PhoenixOptions.StateOption;
import org.dfra.core.host.CommandName;
import org.dfra.report.terminal.CommandFailure;
import org.dfra.report.terminal.CommandOutput;
import org.dfra.report.terminal.ExitCode;
import org.dfra.river.bootstrap.PhoenixProcess;
import org.dfra.river.identity.IdentityFolder;
import org.dfra.river.identity.SecurityFiles;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** {@code ./dfra security join}. */
@Command(
    name = "join",
    description = "Makes this computer a member of a team, with the bundle of its authority.",
    footer = {
      "",
      "Checks all of the bundle before anything is written. Compare the fingerprint that it",
      "prints with the one that the authority's computer shows: if they differ, the bundle is",
      "not from your authority. Robots that run already use the new identity after "
          + CommandName.IN_HELP
          + " down and up.",
      "Joining again as the same member, with a renewed bundle, needs no --force."
    })
final class JoinCommand implements Callable<Integer> {

  @Parameters(paramLabel = "BUNDLE", description = "The file that the authority has issued.")
  @SuppressWarnings("NullAway.Init") // set by picocli before the call
  private Path bundle;

  @Option(
      names = "--passphrase-file",
      paramLabel = "FILE",
      description = "File whose first line is the bundle's passphrase (default: asks for it).")
  private @Nullable Path passphraseFile;

  @Option(
      names = "--force",
      description = "Replace the identity of another member, or one that cannot be read.")
  private boolean isForced;

  /** Only its process matters. */
  private static final int ANY_PORT = 1;

  @Mixin
  @SuppressWarnings("NullAway.Init") // set by picocli before the call
  private StateOption state;

  @Mixin
  @SuppressWarnings("NullAway.Init") // set by picocli before the call
  private CommandOutput answer;

  @Override
  public Integer call() throws Exception {
    requireNoOpenRobots(state.folder());
    Bundle read = Bundle.read(bundle);
    String passphrase =
        PassphraseSource.read(passphraseFile, "passphrase of " + bundle, "--passphrase-file");
    VerifiedBundle verified = VerifiedBundle.open(read, passphrase, bundle.toString());
    IdentityInstaller installer = new IdentityInstaller(state.folder());
    Instant now = Instant.now();
    installer.install(verified, bundle.toString(), now, isForced);
    MemberView view = MemberView.of(verified, now);
    answer.lines(
        view,
        List.of(
            "This computer is "
                + view.member()
                + " now, until "
                + view.validUntil()
                + "; its files are in "
                + installer.folder()
                + ".",
            "Fingerprint of the authority: " + view.authorityFingerprint(),
            "Delete " + bundle + " and its passphrase: nobody needs them again."));
    return ExitCode.SUCCESS;
  }

  /** Robots that were started open would stay so, and commands with an identity cannot end them. */
  private static void requireNoOpenRobots(Path state) {
    PhoenixProcess phoenix = new PhoenixProcess("localhost", ANY_PORT, -1, state);
    OptionalLong pid = phoenix.pid();
    if (pid.isPresent() && !IdentityFolder.isJoined(state.resolve(SecurityFiles.FOLDER))) {
      throw new CommandFailure(
          ExitCode.FAILED,
          "robots of this computer are up and open (phoenix is process "
              + pid.getAsLong()
              + "); end them first, and bring them up again when it has joined: "
              + CommandName.current()
              + " down");
    }
  }
}
