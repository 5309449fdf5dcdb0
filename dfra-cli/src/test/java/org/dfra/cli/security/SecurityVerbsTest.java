package org.dfra.cli.security;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.ArrayList;
import java.util.List;
import org.dfra.cli.Main;
import org.dfra.report.terminal.ExitCode;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import picocli.CommandLine;

/** The verbs of a computer that has joined no team; dfra-authority tests the others. */
class SecurityVerbsTest {

  @TempDir Path temp;

  private final StringWriter out = new StringWriter();
  private final StringWriter err = new StringWriter();

  private int run(String... words) {
    List<String> args = new ArrayList<>(List.of(words));
    args.add("--state=" + temp.resolve("state"));
    CommandLine line = Main.commandLine(args.toArray(String[]::new));
    line.setOut(new PrintWriter(out, true));
    line.setErr(new PrintWriter(err, true));
    return line.execute(args.toArray(String[]::new));
  }

  @Test
  void aComputerThatHasJoinedNoTeamIsOpen() {
    assertThat(run("whoami")).isZero();
    assertThat(out.toString())
        .isEqualTo(
            "Nobody: this computer has joined no team, so its commands prove no identity (open"
                + " mode).\n");
    assertThat(run("whoami", "--json")).isZero();
    assertThat(out.toString()).contains("\"member\" : \"none\"");
    assertThat(temp.resolve("state")).doesNotExist();
  }

  /** Never open after a failure. */
  @Test
  void anIdentityThatCannotBeReadIsNotOpen() throws IOException {
    Path security = Files.createDirectories(temp.resolve("state/security"));
    Files.setPosixFilePermissions(security, PosixFilePermissions.fromString("rwx------"));
    assertThat(run("whoami")).isEqualTo(ExitCode.FAILED);
    assertThat(err.toString())
        .isEqualTo(
            "dfra: "
                + security.resolve("authority.pem")
                + " is missing; join the team again: security join NAME.bundle\n");
    assertThat(out.toString()).isEmpty();
  }

  @Test
  void thereIsNothingToShow() {
    assertThat(run("security", "show")).isEqualTo(ExitCode.FAILED);
    assertThat(err.toString())
        .contains("security does not exist, so this computer has no identity");
  }

  @Test
  void showNeedsAFileThatItKnows() throws IOException {
    Path missing = temp.resolve("missing.pem");
    assertThat(run("security", "show", missing.toString())).isEqualTo(ExitCode.FAILED);
    assertThat(err.toString())
        .isEqualTo(
            "dfra: there is no file " + missing + "; name a bundle, a certificate or a folder\n");
    Path text = Files.writeString(temp.resolve("text.pem"), "no certificate");
    assertThat(run("security", "show", text.toString())).isEqualTo(ExitCode.FAILED);
    assertThat(err.toString()).contains(text + " is neither a bundle nor a certificate");
  }

  @Test
  void joinNeedsABundleAndItsPassphrase() throws IOException {
    assertThat(run("security", "join")).isEqualTo(ExitCode.USAGE_ERROR);
    assertThat(err.toString())
        .isEqualTo(
            "dfra: missing required parameter: 'BUNDLE'; see: ./dfra security join --help\n");
    Path bundle = temp.resolve("atrv1.bundle");
    assertThat(run("security", "join", bundle.toString())).isEqualTo(ExitCode.FAILED);
    assertThat(err.toString()).contains("dfra: there is no file " + bundle + "; name a bundle\n");
    assertThat(temp.resolve("state")).doesNotExist();
  }

  @Test
  void aUsageErrorNamesTheVerbs() {
    List<String> words = List.of("security");
    CommandLine line = Main.commandLine(words.toArray(String[]::new));
    line.setErr(new PrintWriter(err, true));
    assertThat(line.execute("security")).isEqualTo(ExitCode.USAGE_ERROR);
    assertThat(err.toString())
        .isEqualTo("dfra: security needs a verb; there is accept, delegate, join, show\n");
  }
}
