package org.dfra.authority.cli;

import java.io.IOException;
import java.nio.file.Path;
import java.security.SecureRandom;
import java.time.Clock;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.Callable;
import org.dfra.authority.Authority;
import org.dfra.authority.Authority.IssuedBundle;
import org.dfra.cli.security.IdentityInstaller;
import org.dfra.cli.security.OneTimePassphrase;
import org.dfra.cli.security.PassphraseSource;
import org.dfra.cli.security.VerifiedBundle;
import org.dfra.cli.team.PhoenixOptions.StateOption;
import org.dfra.core.host.PrivateFiles;
import org.dfra.report.terminal.CommandOutput;
import org.dfra.report.terminal.ExitCode;
import org.dfra.river.identity.CertificateFingerprint;
import org.dfra.river.identity.IdentityException;
import org.dfra.river.identity.IdentityFolder;
import org.dfra.security.Member;
import org.dfra.security.MemberRole;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code ./dfra security init}. */
@Command(
    name = "init",
    description = "Makes the authority of a new team, and its first operator on this computer.",
    footer = {
      "",
      "Anybody with the folder of the authority and its passphrase can admit members: keep a",
      "copy of both where no robot and no stranger reaches them. Do not run it on a robot."
    })
final class InitCommand implements Callable<Integer> {

  private static final Duration OPERATOR_VALIDITY = Duration.ofDays(365);

  @Parameters(paramLabel = "TEAM", description = "Name of the team: " + Member.NAME_RULE + ".")
  private String team = "";

  @Option(
      names = "--passphrase-file",
      paramLabel = "FILE",
      description =
          "File whose first line is to be the authority's passphrase (default: asks for it).")
  private @Nullable Path passphraseFile;

  @Option(
      names = "--no-passphrase",
      description = "Make a passphrase and store it beside the authority's key.")
  private boolean isStored;

  @Option(
      names = "--operator",
      paramLabel = "NAME",
      description = "Name of the first operator (default: this computer's user).")
  private String operator = System.getProperty("user.name", "");

  @Mixin
  @SuppressWarnings("NullAway.Init") // set by picocli before the call
  private AuthorityFolderOption place;

  @Mixin
  @SuppressWarnings("NullAway.Init") // set by picocli before the call
  private StateOption state;

  @Mixin
  @SuppressWarnings("NullAway.Init") // set by picocli before the call
  private CommandOutput answer;

  @Spec
  @SuppressWarnings("NullAway.Init") // set by picocli before the call
  private CommandSpec spec;

  /** What is printed. */
  private record InitView(String team, String authority, String fingerprint, String operator) {}

  @Override
  public Integer call() throws Exception {
    requireArguments();
    Path folder = place.in(state.folder());
    PrivateFiles.requireFolder(state.folder());
    IdentityInstaller installer = new IdentityInstaller(state.folder());
    boolean wasJoined = IdentityFolder.isJoined(installer.folder());
    String passphrase = passphrase();
    Authority.create(folder, team, passphrase, isStored, Clock.systemUTC());
    try (Authority authority = Authority.open(folder, () -> passphrase, Clock.systemUTC())) {
      if (!wasJoined) {
        join(authority, installer);
      }
      print(authority, folder, installer, wasJoined);
    }
    return ExitCode.SUCCESS;
  }

  private void requireArguments() {
    if (isStored && passphraseFile != null) {
      throw new ParameterException(
          spec.commandLine(), "--passphrase-file and --no-passphrase exclude each other");
    }
    try {
      var unused = new Member(team, MemberRole.OPERATOR, operator);
    } catch (IllegalArgumentException e) {
      throw new ParameterException(
          spec.commandLine(), e.getMessage() + "; the operator's name is set by --operator", e);
    }
  }

  private String passphrase() {
    if (isStored) {
      return OneTimePassphrase.create(new SecureRandom());
    }
    return passphraseFile == null
        ? PassphraseSource.readNew("the authority", "--passphrase-file, or add --no-passphrase")
        : PassphraseSource.read(passphraseFile, "passphrase", "--passphrase-file");
  }

  private void join(Authority authority, IdentityInstaller installer)
      throws IOException, IdentityException {
    IssuedBundle issued = authority.issue(MemberRole.OPERATOR, operator, OPERATOR_VALIDITY);
    String name = "the bundle of operator " + operator;
    VerifiedBundle verified = VerifiedBundle.open(issued.bundle(), issued.passphrase(), name);
    installer.install(verified, name, Instant.now(), false);
  }

  private void print(
      Authority authority, Path folder, IdentityInstaller installer, boolean wasJoined) {
    String fingerprint = CertificateFingerprint.sha256(authority.certificate());
    List<String> lines = new ArrayList<>();
    lines.add("The authority of team " + team + " is in " + folder + ".");
    lines.add(
        wasJoined
            ? "This computer has an identity already, which stays: " + installer.folder()
            : "This computer is operator "
                + operator
                + " of "
                + team
                + " now; its files are in "
                + installer.folder()
                + ".");
    lines.add("Fingerprint of the authority: " + fingerprint);
    answer.lines(
        new InitView(team, folder.toString(), fingerprint, wasJoined ? "" : operator), lines);
  }
}
