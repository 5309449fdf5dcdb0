package org.dfra.authority.cli;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.dfra.authority.Authority;
import org.dfra.authority.IssuedCertificate;
import org.dfra.cli.security.Bundle;
import org.dfra.core.host.CommandName;
import org.dfra.core.host.PrivateFiles;
import org.dfra.report.terminal.CommandFailure;
import org.dfra.report.terminal.CommandOutput;
import org.dfra.report.terminal.ExitCode;
import org.dfra.security.Member;
import org.dfra.security.MemberRole;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;
import picocli.CommandLine.Spec.Target;

/** How long a new certificate is valid, and where it is written. A picocli mix-in. */
final class IssueOptions {

  private static final int ROBOT_DAYS = 90;
  private static final int OTHER_DAYS = 365;
  private static final int MOST_DAYS = 3650;

  @Option(
      names = "--days",
      paramLabel = "N",
      description = "Days for which it is valid (default: 90 for robots, 365 for others).")
  private @Nullable Integer days;

  @Option(
      names = "--out",
      paramLabel = "FILE",
      description =
          "File to write (default: NAME" + Bundle.SUFFIX + ", or NAME.code.p12 for a code key).")
  private @Nullable Path out;

  @Option(
      names = "--passphrase-file",
      paramLabel = "FILE",
      description = "Write the one-time passphrase to this new file (default: prints it).")
  private @Nullable Path passphraseFile;

  @Mixin
  @SuppressWarnings("NullAway.Init") // set by picocli before the call
  private CommandOutput answer;

  @Spec(Target.MIXEE)
  @SuppressWarnings("NullAway.Init") // set by picocli before the call
  private CommandSpec spec;

  /** What is printed: the certificate, the file, and the passphrase if it is written nowhere. */
  private record IssueView(
      IssuedCertificate certificate, String file, Optional<String> passphrase) {}

  /**
   * Issues a certificate, writes its file, and prints what to do with it.
   *
   * @param role {@link MemberRole#text()}, or {@link IssuedCertificate#CODE}
   */
  void issue(Authority authority, String role, String name) throws IOException {
    Duration validity = validity(role);
    boolean isCode = role.equals(IssuedCertificate.CODE);
    Path file = out == null ? Path.of(name + (isCode ? ".code.p12" : Bundle.SUFFIX)) : out;
    requireNew(file, "--out");
    if (passphraseFile != null) {
      requireNew(passphraseFile, "--passphrase-file");
    }
    if (isCode) {
      Authority.IssuedCodeKey issued = authority.issueCode(name, validity);
      write(file, issued.keyStore(), issued.passphrase());
      print(issued.certificate(), file, issued.passphrase(), "Sign jars with it by jarsigner.");
    } else {
      Authority.IssuedBundle issued = authority.issue(MemberRole.of(role), name, validity);
      write(file, issued.bundle().toBytes(), issued.passphrase());
      print(
          issued.certificate(),
          file,
          issued.passphrase(),
          "On its computer: " + CommandName.current() + " security join " + file.getFileName());
    }
  }

  private Duration validity(String role) {
    int usual = role.equals(MemberRole.ROBOT.text()) ? ROBOT_DAYS : OTHER_DAYS;
    int asked = days == null ? usual : days;
    if (asked < 1 || asked > MOST_DAYS) {
      throw new ParameterException(
          spec.commandLine(), "--days=" + asked + " is not a number from 1 to " + MOST_DAYS);
    }
    return Duration.ofDays(asked);
  }

  /** Refuses a name that no member can have, as a usage error. */
  void requireName(String name) {
    try {
      var unused = new Member("team", MemberRole.OBSERVER, name);
    } catch (IllegalArgumentException e) {
      throw new ParameterException(spec.commandLine(), e.getMessage(), e);
    }
  }

  /** Before anything is issued. */
  private static void requireNew(Path file, String option) {
    Path parent = file.toAbsolutePath().getParent();
    if (Files.exists(file)) {
      throw new CommandFailure(
          ExitCode.FAILED, file + " exists already; delete it, or name another with " + option);
    } else if (parent == null || !Files.isWritable(parent)) {
      throw new CommandFailure(
          ExitCode.FAILED,
          "nothing can be written to the folder " + parent + "; name another with " + option);
    }
  }

  private void write(Path file, byte[] content, String passphrase) throws IOException {
    if (passphraseFile != null) {
      PrivateFiles.write(passphraseFile, (passphrase + "\n").getBytes(StandardCharsets.US_ASCII));
    }
    PrivateFiles.write(file, content);
  }

  private void print(IssuedCertificate issued, Path file, String passphrase, String next) {
    List<String> lines = new ArrayList<>();
    lines.add(
        "Issued "
            + issued.owner()
            + " of "
            + issued.team()
            + " until "
            + issued.until()
            + ": "
            + file);
    lines.add(
        passphraseFile == null
            ? "Passphrase: " + passphrase
            : "Its passphrase is in " + passphraseFile + ".");
    lines.add(next);
    Optional<String> printed = passphraseFile == null ? Optional.of(passphrase) : Optional.empty();
    answer.lines(new IssueView(issued, file.toString(), printed), lines);
  }
}
