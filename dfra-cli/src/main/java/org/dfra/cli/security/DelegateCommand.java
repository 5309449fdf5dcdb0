package org.dfra.cli.security;

import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.dfra.cli.team.PhoenixOptions.StateOption;
import org.dfra.core.host.CommandName;
import org.dfra.core.host.PrivateFiles;
import org.dfra.report.terminal.CommandFailure;
import org.dfra.report.terminal.CommandOutput;
import org.dfra.report.terminal.ExitCode;
import org.dfra.river.identity.Delegation;
import org.dfra.river.identity.IdentityException;
import org.dfra.river.identity.IdentityFolder;
import org.dfra.river.identity.SecurityFiles;
import org.dfra.river.identity.StoredDelegations;
import org.dfra.river.identity.TeamCredentials;
import org.dfra.security.Member;
import org.dfra.security.MemberRole;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** {@code ./dfra security delegate}. */
@Command(
    name = "delegate",
    description = "Lets another member command robots on behalf of this computer's operator.",
    footer = {
      "",
      "Writes a file for the other member, whose computer takes it by",
      CommandName.IN_HELP
          + " security accept. It is no secret: it names the other one's certificate, so nobody",
      "else can use it. It ends with its time, and as soon as one of both members is revoked.",
      "All who may command that member can make it command the robots. The team's policy must",
      "permit the other one to act for operators, as the one that comes with DFRA does."
    })
final class DelegateCommand implements Callable<Integer> {

  private static final Pattern SPAN = Pattern.compile("([1-9][0-9]{0,3})([mh])");

  @Parameters(
      index = "0",
      paramLabel = "ROLE",
      description = "Role of the other member: robot or observer.")
  private String role = "";

  @Parameters(index = "1", paramLabel = "NAME", description = "Name of the other member.")
  private String name = "";

  @Option(
      names = "--robots",
      paramLabel = "ROBOT",
      required = true,
      split = ",",
      description = "The robots that it may command; several are separated by commas.")
  private List<String> robots = List.of();

  @Option(
      names = "--fingerprint",
      paramLabel = "SHA256",
      required = true,
      description =
          "Fingerprint of the other one's certificate, which "
              + CommandName.IN_HELP
              + " whoami on its computer shows.")
  private String fingerprint = "";

  @Option(
      names = "--for",
      paramLabel = "TIME",
      description = "How long it may: minutes or hours, at most 24h (default ${DEFAULT-VALUE}).")
  private String span = "2h";

  @Option(
      names = "--out",
      paramLabel = "FILE",
      description = "The file to write (default: OPERATOR-for-NAME.delegation in this folder).")
  private @Nullable Path out;

  @Mixin
  @SuppressWarnings("NullAway.Init") // set by picocli before the call
  private StateOption state;

  @Mixin
  @SuppressWarnings("NullAway.Init") // set by picocli before the call
  private CommandOutput answer;

  @Override
  public Integer call() throws Exception {
    TeamCredentials own = operator();
    Instant now = Instant.now();
    Delegation made;
    try {
      made =
          Delegation.sign(
              own,
              new Member(own.member().team(), MemberRole.of(role), name),
              fingerprint.replace(":", "").toLowerCase(Locale.ROOT),
              robots,
              now,
              now.plus(span()));
    } catch (IllegalArgumentException e) {
      throw new CommandFailure(ExitCode.USAGE_ERROR, String.valueOf(e.getMessage()), e);
    }
    Path file =
        out == null
            ? Path.of(own.member().name() + "-for-" + name + StoredDelegations.SUFFIX)
            : out;
    if (Files.exists(file)) {
      throw new CommandFailure(
          ExitCode.FAILED, file + " exists; delete it, or name another file with --out");
    }
    @Nullable Path folder = file.toAbsolutePath().getParent();
    if (folder == null || !Files.isDirectory(folder)) {
      throw new CommandFailure(
          ExitCode.FAILED, "there is no folder " + folder + " for " + file + "; make it first");
    }
    PrivateFiles.write(file, made.text().getBytes(StandardCharsets.US_ASCII));
    answer.lines(
        DelegationView.of(made, now),
        List.of(
            "The "
                + made.bearer()
                + " may command "
                + String.join(", ", made.robots())
                + " on your behalf until "
                + made.until()
                + ", after it has taken "
                + file
                + ":",
            "    " + CommandName.current() + " security accept " + file.getFileName()));
    return ExitCode.SUCCESS;
  }

  private TeamCredentials operator() throws IdentityException {
    TeamCredentials own = IdentityFolder.load(state.folder().resolve(SecurityFiles.FOLDER));
    Optional<String> fault = own.validityFault(Instant.now());
    if (own.member().role() != MemberRole.OPERATOR) {
      throw new IdentityException(
          "only an operator delegates, and this computer is " + own.member());
    } else if (own.isRevoked()) {
      throw new IdentityException("the certificate of " + own.member() + " is revoked");
    } else if (fault.isPresent()) {
      throw new IdentityException(fault.get());
    }
    return own;
  }

  private Duration span() {
    Matcher read = SPAN.matcher(span);
    if (!read.matches()) {
      throw new CommandFailure(
          ExitCode.USAGE_ERROR, "--for=" + span + " is not a time such as 30m or 2h");
    }
    long number = Long.parseLong(read.group(1));
    return read.group(2).equals("m") ? Duration.ofMinutes(number) : Duration.ofHours(number);
  }
}
