package org.dfra.authority.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.attribute.PosixFilePermissions;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import org.dfra.authority.QuickKeyStores;
import org.dfra.cli.Main;
import org.dfra.report.terminal.ExitCode;
import org.dfra.river.identity.Delegation;
import org.dfra.river.identity.IdentityFolder;
import org.dfra.river.identity.TeamCredentials;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.ExtendWith;
import org.junit.jupiter.api.io.TempDir;
import picocli.CommandLine;

/** {@code security delegate} and {@code accept}, and what becomes of files in the wrong place. */
@ExtendWith(QuickKeyStores.class)
class DelegationCommandsTest {

  private static final String ANNA = "anna";
  private static final String OTTO = "otto";

  @TempDir Path temp;

  private String out = "";
  private String err = "";

  private int at(String computer, String... words) {
    List<String> args = new ArrayList<>(List.of(words));
    args.add("--state=" + temp.resolve(computer));
    StringWriter outText = new StringWriter();
    StringWriter errText = new StringWriter();
    CommandLine line = Main.commandLine(args.toArray(String[]::new));
    line.setOut(new PrintWriter(outText, true));
    line.setErr(new PrintWriter(errText, true));
    int exit = line.execute(args.toArray(String[]::new));
    out = outText.toString();
    err = errText.toString();
    return exit;
  }

  private void succeeds(int exit) {
    assertThat(exit).as(out + err).isZero();
  }

  @BeforeEach
  void team() {
    succeeds(at(ANNA, "security", "init", "field", "--no-passphrase", "--operator=anna"));
    String bundle = temp.resolve("otto.bundle").toString();
    String passphrase = "--passphrase-file=" + temp.resolve("otto.pass");
    succeeds(at(ANNA, "security", "issue", "observer", OTTO, "--out=" + bundle, passphrase));
    succeeds(at(OTTO, "security", "join", bundle, passphrase));
  }

  private TeamCredentials member(String computer) throws Exception {
    return IdentityFolder.load(temp.resolve(computer).resolve("security"));
  }

  private Path write(Path file, String text) throws Exception {
    Files.writeString(file, text);
    return Files.setPosixFilePermissions(file, PosixFilePermissions.fromString("rw-------"));
  }

  private Path delegate() throws Exception {
    Path file = temp.resolve("a.delegation");
    Files.deleteIfExists(file);
    String fingerprint = Delegation.fingerprint(member(OTTO).certificate());
    succeeds(
        at(
            ANNA,
            "security",
            "delegate",
            "observer",
            OTTO,
            "--robots=atrv1",
            "--fingerprint=" + fingerprint,
            "--out=" + file));
    return file;
  }

  @Test
  void onlyWhatIsOfUseIsShownAsIfItWere() throws Exception {
    Path file = delegate();
    succeeds(at(OTTO, "security", "accept", file.toString()));
    succeeds(at(OTTO, "whoami"));
    assertThat(out).contains("May command atrv1 for operator anna of field until ");
    Path elsewhere = temp.resolve(ANNA).resolve("security/operator-anna.delegation");
    Files.copy(file, elsewhere, StandardCopyOption.COPY_ATTRIBUTES);
    succeeds(at(ANNA, "whoami"));
    assertThat(out)
        .doesNotContain("May command")
        .contains(
            "Not used: "
                + elsewhere
                + " is for a certificate of observer otto of field that is not the one here;"
                + " delete it.");
  }

  @Test
  void aDamagedFileHidesNeitherTheMemberNorTheOtherFiles() throws Exception {
    Path damaged = write(temp.resolve(OTTO).resolve("security/zz.delegation"), "garbage\n");
    succeeds(at(OTTO, "whoami"));
    assertThat(out)
        .startsWith("The observer otto of field, valid until ")
        .contains("Not used: " + damaged + " does not begin with");
    succeeds(at(OTTO, "security", "accept", delegate().toString()));
    succeeds(at(OTTO, "security", "show"));
    assertThat(out).contains("May command atrv1 for operator anna of field");
  }

  @Test
  void acceptingOneDeletesExpiredOnesAndNotItself() throws Exception {
    TeamCredentials otto = member(OTTO);
    Instant then = Instant.now().minus(Duration.ofHours(3));
    Delegation former =
        Delegation.sign(
            member(ANNA),
            otto.member(),
            Delegation.fingerprint(otto.certificate()),
            List.of("atrv1"),
            then,
            then.plus(Duration.ofHours(1)));
    Path copied =
        write(
            temp.resolve(OTTO).resolve("security/anna-for-otto.delegation"),
            new String(former.bytes(), StandardCharsets.US_ASCII));
    succeeds(at(OTTO, "security", "accept", delegate().toString()));
    assertThat(copied).doesNotExist();
    succeeds(at(OTTO, "whoami"));
    assertThat(out).contains("May command atrv1 for operator anna of field until ");
  }

  @Test
  void aFileThatCannotBeWrittenIsNamed() throws Exception {
    Path file = temp.resolve("missing/a.delegation");
    String fingerprint = "--fingerprint=" + Delegation.fingerprint(member(OTTO).certificate());
    int exit =
        at(
            ANNA,
            "security",
            "delegate",
            "observer",
            OTTO,
            "--robots=atrv1",
            fingerprint,
            "--out=" + file);
    assertThat(exit).isEqualTo(ExitCode.FAILED);
    assertThat(err)
        .isEqualTo(
            "dfra: there is no folder " + file.getParent() + " for " + file + "; make it first\n");
  }
}
