package org.dfra.authority;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Clock;
import java.time.Duration;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.dfra.cli.security.VerifiedBundle;
import org.dfra.security.MemberRole;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.ExtendWith;
import org.junit.jupiter.api.io.TempDir;

/** OpenSSL and keytool read what the authority writes; neither shares code with it. */
@ExtendWith(QuickKeyStores.class)
class IndependentReaderTest {

  private static final Duration DAY = Duration.ofDays(1);

  @TempDir Path temp;

  private Path folder;
  private Authority.IssuedBundle robot;
  private Path certificate;

  @BeforeEach
  void issue() throws Exception {
    folder = temp.resolve("authority");
    Authority.create(folder, "field", "secret", false, Clock.systemUTC());
    try (Authority authority = Authority.open(folder, () -> "secret", Clock.systemUTC())) {
      robot = authority.issue(MemberRole.ROBOT, "atrv1", DAY);
    }
    VerifiedBundle verified = VerifiedBundle.open(robot.bundle(), robot.passphrase(), "bundle");
    certificate = temp.resolve("atrv1.pem");
    Files.write(certificate, AuthoritySignatures.pem(verified.certificate()));
  }

  /** What a program prints, and its exit status in the first line. */
  private static String run(String... words) throws IOException, InterruptedException {
    Process process = new ProcessBuilder(words).redirectErrorStream(true).start();
    process.getOutputStream().close();
    String text = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    assertThat(process.waitFor(60, TimeUnit.SECONDS)).as("%s ends", List.of(words)).isTrue();
    return process.exitValue() + "\n" + text;
  }

  private static String openssl(String... words) throws IOException, InterruptedException {
    String[] command = new String[words.length + 1];
    command[0] = "openssl";
    System.arraycopy(words, 0, command, 1, words.length);
    return run(command);
  }

  private static void assumeOpenssl() throws InterruptedException {
    boolean isThere;
    try {
      isThere = openssl("version").startsWith("0\n");
    } catch (IOException e) {
      isThere = false;
    }
    assumeTrue(isThere, "openssl is not installed here");
  }

  private String verify(String purpose) throws Exception {
    return openssl(
        "verify",
        "-x509_strict",
        "-purpose",
        purpose,
        "-CAfile",
        folder.resolve("authority.pem").toString(),
        certificate.toString());
  }

  @Test
  void opensslAcceptsAMemberAtBothEndsOfAConnectionOnly() throws Exception {
    assumeOpenssl();
    assertThat(verify("sslclient")).startsWith("0\n").contains("OK");
    assertThat(verify("sslserver")).startsWith("0\n").contains("OK");
    assertThat(verify("smimesign")).doesNotStartWith("0\n");
    assertThat(openssl("x509", "-in", certificate.toString(), "-noout", "-text"))
        .contains("CA:FALSE", "P-256", "ecdsa-with-SHA256", "Digital Signature")
        .containsPattern("O ?= ?field, OU ?= ?robot, CN ?= ?atrv1");
  }

  @Test
  void opensslRefusesARevokedMember() throws Exception {
    assumeOpenssl();
    String list = folder.resolve("revoked.crl").toString();
    String authorityPem = folder.resolve("authority.pem").toString();
    Path pem = temp.resolve("list.pem");
    String[] check = {
      "verify",
      "-crl_check",
      "-CAfile",
      authorityPem,
      "-CRLfile",
      pem.toString(),
      certificate.toString()
    };
    String[] read = {
      "crl", "-inform", "DER", "-in", list, "-CAfile", authorityPem, "-text", "-out", pem.toString()
    };
    assertThat(openssl(read)).startsWith("0\n").contains("verify OK");
    assertThat(openssl(check)).startsWith("0\n");
    try (Authority authority = Authority.open(folder, () -> "secret", Clock.systemUTC())) {
      authority.revoke(each -> true, "stolen");
    }
    assertThat(openssl(read)).startsWith("0\n").contains("verify OK");
    assertThat(Files.readString(pem)).containsPattern("CRL Number: *\\s+2");
    assertThat(openssl(check)).doesNotStartWith("0\n").contains("revoked");
  }

  @Test
  void keytoolListsTheKeyStore() throws Exception {
    Path keytool = Path.of(System.getProperty("java.home"), "bin", "keytool");
    assumeTrue(Files.isExecutable(keytool), "this Java has no keytool");
    Path store = temp.resolve("identity.p12");
    Files.write(store, robot.bundle().file("identity.p12").orElseThrow());
    String listed =
        run(
            keytool.toString(),
            "-J-XX:TieredStopAtLevel=1",
            "-list",
            "-v",
            "-storetype",
            "PKCS12",
            "-keystore",
            store.toString(),
            "-storepass",
            robot.passphrase());
    assertThat(listed)
        .startsWith("0\n")
        .contains("identity", "CN=atrv1, OU=robot, O=field", "CN=field authority, O=field")
        .contains("serverAuth", "clientAuth");
  }
}
