package org.dfra.authority.cli;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeFalse;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.dfra.authority.QuickKeyStores;
import org.dfra.cli.Main;
import org.dfra.report.terminal.ExitCode;
import org.dfra.river.identity.IdentityFolder;
import org.dfra.river.identity.TeamCredentials;
import org.dfra.security.MemberRole;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.ExtendWith;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import picocli.CommandLine;

/** The verbs of the authority, and what becomes of their bundles on other computers. */
@ExtendWith(QuickKeyStores.class)
class SecurityCommandsTest {

  private static final Pattern FINGERPRINT =
      Pattern.compile("Fingerprint of the authority: ([0-9A-F:]{95})");

  @TempDir Path temp;

  private String out = "";
  private String err = "";

  private int run(String... args) {
    StringWriter outText = new StringWriter();
    StringWriter errText = new StringWriter();
    CommandLine line = Main.commandLine(args);
    line.setOut(new PrintWriter(outText, true));
    line.setErr(new PrintWriter(errText, true));
    int exit = line.execute(args);
    out = outText.toString();
    err = errText.toString();
    return exit;
  }

  /** On the authority's computer. */
  private int operator(String... args) {
    return at("operator", args);
  }

  private int at(String computer, String... args) {
    String[] all = java.util.Arrays.copyOf(args, args.length + 1);
    all[args.length] = "--state=" + temp.resolve(computer);
    return run(all);
  }

  private void succeeds(int exit) {
    assertThat(exit).as(out + err).isZero();
    assertThat(err).isEmpty();
  }

  private void fails(int exit, String sentence) {
    assertThat(exit).as(out).isEqualTo(ExitCode.FAILED);
    assertThat(err).isEqualTo("dfra: " + sentence + "\n");
    assertThat(out).isEmpty();
  }

  private void init() {
    succeeds(operator("security", "init", "field", "--no-passphrase", "--operator=anna"));
  }

  private Path issue(String role, String name) {
    Path bundle = temp.resolve(name + ".bundle");
    succeeds(
        operator(
            "security",
            "issue",
            role,
            name,
            "--out=" + bundle,
            "--passphrase-file=" + temp.resolve(name + ".pass")));
    return bundle;
  }

  private int join(String computer, String name) {
    return at(
        computer,
        "security",
        "join",
        temp.resolve(name + ".bundle").toString(),
        "--passphrase-file=" + temp.resolve(name + ".pass"));
  }

  private String fingerprint() {
    Matcher found = FINGERPRINT.matcher(out);
    assertThat(found.find()).as(out).isTrue();
    return found.group(1);
  }

  @Test
  void threeCommandsMakeATeam() throws Exception {
    init();
    assertThat(out)
        .contains("The authority of team field is in " + temp.resolve("operator/authority") + ".")
        .contains("This computer is operator anna of field now");
    String fingerprint = fingerprint();
    succeeds(operator("whoami"));
    assertThat(out).startsWith("The operator anna of field, valid until ");

    Path bundle = issue("robot", "atrv1");
    assertThat(out)
        .startsWith("Issued robot atrv1 of field until ")
        .contains(
            ": " + bundle + "\n",
            "Its passphrase is in " + temp.resolve("atrv1.pass") + ".",
            "On its computer: ./dfra security join atrv1.bundle");
    succeeds(join("robot", "atrv1"));
    assertThat(out)
        .startsWith("This computer is robot atrv1 of field now, until ")
        .contains("its files are in " + temp.resolve("robot/security") + ".");
    assertThat(fingerprint()).isEqualTo(fingerprint);

    succeeds(at("robot", "whoami"));
    assertThat(out).startsWith("The robot atrv1 of field, valid until ");
    TeamCredentials robot = IdentityFolder.load(temp.resolve("robot/security"));
    TeamCredentials anna = IdentityFolder.load(temp.resolve("operator/security"));
    assertThat(robot.member().role()).isEqualTo(MemberRole.ROBOT);
    assertThat(robot.authority()).isEqualTo(anna.authority());
    assertThat(robot.robotKey()).isPresent();
    assertThat(anna.robotKey()).isEmpty();
  }

  @Test
  void aPassphraseThatIsPrintedOpensTheBundle() throws Exception {
    init();
    Path bundle = temp.resolve("ben.bundle");
    succeeds(operator("security", "issue", "OBSERVER", "ben", "--out=" + bundle, "--days=3"));
    Matcher passphrase = Pattern.compile("Passphrase: (\\S+)").matcher(out);
    assertThat(passphrase.find()).as(out).isTrue();
    Files.writeString(temp.resolve("ben.pass"), passphrase.group(1).toUpperCase() + "\n");
    succeeds(join("observer", "ben"));
    succeeds(
        operator(
            "security",
            "issue",
            "observer",
            "cleo",
            "--json",
            "--out=" + temp.resolve("cleo.bundle")));
    assertThat(out).contains("\"passphrase\" : \"", "\"role\" : \"observer\"");
  }

  @Test
  void showsBundleIdentityAuthorityAndCertificate() throws Exception {
    init();
    Path bundle = issue("robot", "atrv1");
    succeeds(join("robot", "atrv1"));
    succeeds(at("robot", "security", "show"));
    String identity = out;
    assertThat(identity)
        .contains("CN=atrv1,OU=robot,O=field", "CN=field authority,O=field", "atrv1", "valid");
    succeeds(
        run(
            "security",
            "show",
            bundle.toString(),
            "--passphrase-file=" + temp.resolve("atrv1.pass")));
    assertThat(out).isEqualTo(identity);
    succeeds(run("security", "show", temp.resolve("operator/authority").toString()));
    assertThat(out).contains("CN=field authority,O=field", "authority").doesNotContain("atrv1");
    succeeds(run("security", "show", temp.resolve("robot/security/authority.pem").toString()));
    assertThat(out).contains("CN=field authority,O=field");
    succeeds(run("security", "show", "--json", temp.resolve("robot/security").toString()));
    assertThat(out).contains("\"revocationList\" : 1", "\"state\" : \"valid\"");
  }

  @Test
  void revokingIsListedAndReachesTheOperatorsOwnIdentity() throws Exception {
    init();
    issue("robot", "atrv1");
    succeeds(join("robot", "atrv1"));
    succeeds(operator("security", "revoke", "atrv1", "--reason=it was stolen"));
    assertThat(out)
        .isEqualTo(
            "Revoked robot atrv1: 1 certificate.\nList 2 is "
                + temp.resolve("operator/authority/revoked.crl")
                + ".\nThis computer's identity has it too.\n"
                + "No robot was asked: this computer has no usable identity of the team. Each robot"
                + " gets it from the next member that has it.\n");
    succeeds(operator("security", "list"));
    assertThat(out).contains("robot atrv1", "revoked", "it was stolen", "operator anna", "valid");
    TeamCredentials anna = IdentityFolder.load(temp.resolve("operator/security"));
    TeamCredentials robot = IdentityFolder.load(temp.resolve("robot/security"));
    assertThat(anna.revocations().orElseThrow().isRevoked(robot.certificate())).isTrue();
    succeeds(operator("security", "revoke", "atrv1"));
    assertThat(out).startsWith("All certificates of robot atrv1 were revoked before.");
    fails(
        operator("security", "renew", "atrv1", "--out=" + temp.resolve("new.bundle")),
        "robot atrv1 is revoked; to admit it again, type: ./dfra security issue robot atrv1");
    assertThat(temp.resolve("new.bundle")).doesNotExist();
  }

  @Test
  void aPublishedPolicyIsSignedAndReachesTheOperatorsOwnIdentity() throws Exception {
    init();
    Path policy = temp.resolve("operator/authority/policy.xml");
    Path own = temp.resolve("operator/security/policy.xml");
    String text = Files.readString(policy);
    String stricter = text.replace("</policy>", "  <deny name=\"more\" kind=\"read\"/>\n</policy>");
    Files.writeString(policy, stricter);
    assertThat(operator("security", "publish")).isEqualTo(ExitCode.FAILED);
    assertThat(err).contains("; raise the version in " + policy).hasLineCount(1);
    assertThat(own).hasContent(text);

    Files.writeString(policy, stricter.replace("version=\"1\"", "version=\"2\""));
    succeeds(operator("security", "publish"));
    assertThat(out).startsWith("Signed policy 2 of field: " + policy + "\n");
    assertThat(own).hasSameTextualContentAs(policy);
    succeeds(operator("security", "show"));
    assertThat(out).containsPattern("policy[^\n]*: 2\n");

    Files.writeString(policy, "<policy/>");
    assertThat(operator("security", "publish")).isEqualTo(ExitCode.FAILED);
    assertThat(err).contains(policy.toString());
    assertThat(own).hasContent(stricter.replace("version=\"1\"", "version=\"2\""));
  }

  @Test
  void aComputerWithoutIdentityPublishesNothing() {
    init();
    assertThat(temp.resolve("operator/security").toFile().renameTo(temp.resolve("away").toFile()))
        .isTrue();
    assertThat(operator("security", "publish")).isEqualTo(ExitCode.FAILED);
    assertThat(err).contains("this computer has no identity of team field").hasLineCount(1);
  }

  @Test
  void aRenewedBundleIsJoinedAgain() throws Exception {
    init();
    issue("robot", "atrv1");
    succeeds(join("robot", "atrv1"));
    TeamCredentials first = IdentityFolder.load(temp.resolve("robot/security"));
    Files.delete(temp.resolve("atrv1.bundle"));
    Files.delete(temp.resolve("atrv1.pass"));
    succeeds(
        operator(
            "security",
            "renew",
            "atrv1",
            "--out=" + temp.resolve("atrv1.bundle"),
            "--passphrase-file=" + temp.resolve("atrv1.pass")));
    succeeds(join("robot", "atrv1"));
    TeamCredentials second = IdentityFolder.load(temp.resolve("robot/security"));
    assertThat(second.certificate()).isNotEqualTo(first.certificate());
    assertThat(second.robotKey().orElseThrow().certificate())
        .isEqualTo(first.robotKey().orElseThrow().certificate());
  }

  @Test
  void aKeyForCodeIsInAKeyStore() {
    init();
    Path store = temp.resolve("release.code.p12");
    succeeds(operator("security", "issue", "code", "release", "--out=" + store));
    assertThat(store).exists();
    fails(
        at("robot", "security", "join", store.toString(), "--passphrase-file=" + store),
        store + " is no bundle of a member, since it has no identity.p12; ask for a new bundle");
  }

  @Test
  void twoMembersOfOneNameNeedTheirRole() {
    init();
    issue("robot", "eta");
    Path other = temp.resolve("eta-operator.bundle");
    succeeds(operator("security", "issue", "operator", "eta", "--out=" + other));
    assertThat(operator("security", "revoke", "eta")).isEqualTo(ExitCode.NOT_FOUND);
    assertThat(err).isEqualTo("dfra: there are robot eta, operator eta; say which with --role\n");
    succeeds(operator("security", "revoke", "eta", "--role=operator"));
    assertThat(out).startsWith("Revoked operator eta: 1 certificate.");
    assertThat(operator("security", "revoke", "theta")).isEqualTo(ExitCode.NOT_FOUND);
    assertThat(err)
        .isEqualTo(
            "dfra: the authority has issued no certificate to theta; ./dfra security list shows"
                + " all\n");
  }

  @Test
  void nothingIsOverwrittenOrIssuedInVain() throws IOException {
    init();
    Path bundle = issue("robot", "atrv1");
    fails(
        operator("security", "issue", "robot", "atrv1", "--out=" + bundle),
        bundle + " exists already; delete it, or name another with --out");
    Path missing = temp.resolve("missing");
    fails(
        operator("security", "issue", "robot", "atrv2", "--out=" + missing.resolve("a.bundle")),
        "nothing can be written to the folder " + missing + "; name another with --out");
    fails(
        operator(
            "security",
            "issue",
            "robot",
            "atrv2",
            "--out=" + temp.resolve("b"),
            "--passphrase-file=" + bundle),
        bundle + " exists already; delete it, or name another with --passphrase-file");
    succeeds(operator("security", "list"));
    assertThat(out).doesNotContain("atrv2");
    fails(
        operator("security", "init", "field", "--no-passphrase"),
        temp.resolve("operator/authority")
            + " exists already; name another folder with --authority");
  }

  @Test
  void anAuthorityWithAPassphraseNeedsIt() throws IOException {
    Path passphrase = Files.writeString(temp.resolve("authority.pass"), "correct horse\n");
    Path wrong = Files.writeString(temp.resolve("wrong.pass"), "battery staple\n");
    succeeds(
        operator(
            "security", "init", "field", "--operator=anna", "--passphrase-file=" + passphrase));
    assertThat(temp.resolve("operator/authority/authority.pass")).doesNotExist();
    String[] issue = {
      "security", "issue", "robot", "atrv1", "--out=" + temp.resolve("atrv1.bundle"), ""
    };
    issue[5] = "--authority-passphrase-file=" + wrong;
    fails(
        operator(issue),
        "the passphrase of " + temp.resolve("operator/authority/authority.p12") + " is wrong");
    issue[5] = "--authority-passphrase-file=" + passphrase;
    succeeds(operator(issue));
    succeeds(operator("security", "list"));
    assumeFalse(System.console() != null, "this test has a terminal");
    fails(
        operator("security", "revoke", "atrv1"),
        "there is no terminal on which to ask for the passphrase of the authority; name a file with"
            + " --authority-passphrase-file");
    fails(
        at("other", "security", "init", "field"),
        "there is no terminal on which to ask for the new passphrase of the authority; name a file"
            + " with --passphrase-file, or add --no-passphrase");
  }

  @Test
  void joiningWithAWrongPassphraseChangesNothing() throws IOException {
    init();
    issue("robot", "atrv1");
    Path bundle = temp.resolve("atrv1.bundle");
    Files.writeString(temp.resolve("atrv1.pass"), "guessed\n");
    fails(join("robot", "atrv1"), "the passphrase of " + bundle + " (identity.p12) is wrong");
    assertThat(temp.resolve("robot")).doesNotExist();
    fails(join("operator", "atrv1"), "the passphrase of " + bundle + " (identity.p12) is wrong");
    succeeds(operator("whoami"));
    assertThat(out).startsWith("The operator anna of field");
  }

  @Test
  void aSecondAuthorityLeavesTheIdentityThatIsThere() {
    init();
    succeeds(
        operator(
            "security",
            "init",
            "other",
            "--no-passphrase",
            "--authority=" + temp.resolve("second")));
    assertThat(out).contains("This computer has an identity already, which stays");
    succeeds(operator("whoami"));
    assertThat(out).startsWith("The operator anna of field");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "init | missing required parameter: 'TEAM'",
        "init field --frobnicate | unknown option: '--frobnicate'",
        "issue robot | missing required parameter: 'NAME'",
        "issue king arthur | ROLE cannot be \"king\"; it is one of robot, operator, observer, code",
        "issue robot atrv1 --days=0 | --days=0 is not a number from 1 to 3650",
        "issue robot atrv1 --days=many | --days=many is not a whole number",
        "issue robot ../atrv1 | name \"../atrv1\" is not 1 to 64 letters, digits, dots, hyphens"
            + " and underscores, the first a letter or digit",
        "revoke | missing required parameter: 'NAME'",
        "revoke a --role=king | --role cannot be \"king\"; it is one of robot, operator,"
            + " observer, code",
        "renew | missing required parameter: 'NAME'",
        "list more | unmatched argument at index 2: 'more'",
      })
  void aUsageErrorIsReportedInOneSentence(String asked, String sentence) {
    init();
    String[] words = ("security " + asked + " --state=" + temp.resolve("operator")).split(" ");
    assertThat(run(words)).isEqualTo(ExitCode.USAGE_ERROR);
    assertThat(err)
        .isEqualTo("dfra: " + sentence + "; see: ./dfra security " + words[1] + " --help\n");
    assertThat(out).isEmpty();
  }

  @Test
  void aReasonIsShort() {
    init();
    issue("robot", "atrv1");
    assertThat(operator("security", "revoke", "atrv1", "--reason=" + "x".repeat(201)))
        .isEqualTo(ExitCode.USAGE_ERROR);
    assertThat(err).contains("--reason has 201 characters, at most 200 are kept");
    succeeds(operator("security", "list"));
    assertThat(out).doesNotContain("revoked");
  }

  @Test
  void namesAreCheckedBeforeAnythingIsMade() {
    assertThat(operator("security", "init", "no team", "--no-passphrase"))
        .isEqualTo(ExitCode.USAGE_ERROR);
    assertThat(err).contains("team \"no team\" is not 1 to 64 letters");
    assertThat(operator("security", "init", "field", "--no-passphrase", "--operator=a b"))
        .isEqualTo(ExitCode.USAGE_ERROR);
    assertThat(err).contains("name \"a b\" is not 1 to 64 letters", "--operator");
    assertThat(operator("security", "init", "field", "--no-passphrase", "--passphrase-file=secret"))
        .isEqualTo(ExitCode.USAGE_ERROR);
    assertThat(err).contains("--passphrase-file and --no-passphrase exclude each other");
    assertThat(temp).isEmptyDirectory();
  }

  @ParameterizedTest
  @CsvSource({"list", "issue robot atrv1", "revoke atrv1", "renew atrv1"})
  void aMissingAuthorityIsNamed(String asked) {
    fails(
        operator(("security " + asked).split(" ")),
        "there is no authority in "
            + temp.resolve("operator/authority")
            + "; make one with \"security init TEAM\", or name its folder with --authority");
  }
}
