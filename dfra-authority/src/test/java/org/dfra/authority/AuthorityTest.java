package org.dfra.authority;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.math.BigInteger;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.security.cert.CertificateFactory;
import java.security.cert.X509CRL;
import java.security.cert.X509Certificate;
import java.security.interfaces.ECPublicKey;
import java.time.Clock;
import java.time.Duration;
import java.time.Instant;
import java.time.ZoneOffset;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.dfra.authority.Authority.IssuedBundle;
import org.dfra.authority.Authority.IssuedCodeKey;
import org.dfra.cli.security.VerifiedBundle;
import org.dfra.core.config.ConfigurationException;
import org.dfra.core.policy.BuiltInPolicies;
import org.dfra.river.identity.IdentityException;
import org.dfra.river.identity.KeyEntry;
import org.dfra.river.identity.TeamCertificates;
import org.dfra.security.Member;
import org.dfra.security.MemberRole;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.ExtendWith;
import org.junit.jupiter.api.io.TempDir;

/** What an authority issues and revokes, and what it never forgets. */
@ExtendWith(QuickKeyStores.class)
class AuthorityTest {

  private static final Instant NOW = Instant.parse("2026-11-28T12:00:00.123Z");
  private static final Clock CLOCK = Clock.fixed(NOW, ZoneOffset.UTC);
  private static final Duration DAYS_90 = Duration.ofDays(90);

  @TempDir Path temp;

  private Path folder;

  @BeforeEach
  void create() throws IOException {
    folder = temp.resolve("authority");
    Authority.create(folder, "field", "secret", false, CLOCK);
  }

  private Authority open() throws IOException {
    return Authority.open(folder, () -> "secret", CLOCK);
  }

  private static VerifiedBundle verified(IssuedBundle issued) throws IdentityException {
    return VerifiedBundle.open(issued.bundle(), issued.passphrase(), "bundle");
  }

  private X509CRL list() throws Exception {
    byte[] bytes = Files.readAllBytes(folder.resolve("revoked.crl"));
    return (X509CRL)
        CertificateFactory.getInstance("X.509").generateCRL(new ByteArrayInputStream(bytes));
  }

  @Test
  void itsCertificateSignsMembersAndListsOnly() throws Exception {
    try (Authority authority = open()) {
      X509Certificate certificate = authority.certificate();
      assertThat(certificate.getSubjectX500Principal().getName())
          .isEqualTo("CN=field authority,O=field");
      assertThat(certificate.getBasicConstraints()).as("path length").isZero();
      assertThat(certificate.getKeyUsage())
          .containsExactly(false, false, false, false, false, true, true, false, false);
      assertThat(((ECPublicKey) certificate.getPublicKey()).getParams().getCurve().getField())
          .extracting(field -> field.getFieldSize())
          .isEqualTo(256);
      certificate.verify(certificate.getPublicKey());
      assertThat(authority.team()).isEqualTo("field");
      assertThat(authority.revocationNumber()).isEqualTo(BigInteger.ONE);
    }
  }

  @Test
  void itsFilesArePrivate() throws Exception {
    assertThat(PosixFilePermissions.toString(Files.getPosixFilePermissions(folder)))
        .isEqualTo("rwx------");
    open().close();
    try (var files = Files.list(folder)) {
      assertThat(files)
          .extracting(each -> each.getFileName().toString())
          .contains("authority.p12", "authority.pem", "revoked.crl", "issued.jsonl")
          .doesNotContain("authority.pass");
    }
    try (var files = Files.list(folder)) {
      for (Path each : files.toList()) {
        assertThat(PosixFilePermissions.toString(Files.getPosixFilePermissions(each)))
            .as("%s", each)
            .isEqualTo("rw-------");
      }
    }
  }

  @Test
  void aMembersCertificateIsForBothEndsOfConnections() throws Exception {
    try (Authority authority = open()) {
      VerifiedBundle bundle = verified(authority.issue(MemberRole.ROBOT, "atrv1", DAYS_90));
      X509Certificate certificate = bundle.certificate();
      assertThat(bundle.member()).isEqualTo(new Member("field", MemberRole.ROBOT, "atrv1"));
      assertThat(certificate.getSubjectX500Principal()).isEqualTo(bundle.member().x500());
      assertThat(certificate.getExtendedKeyUsage())
          .containsExactlyInAnyOrder("1.3.6.1.5.5.7.3.1", "1.3.6.1.5.5.7.3.2");
      assertThat(certificate.getKeyUsage())
          .containsExactly(true, false, false, false, false, false, false, false, false);
      assertThat(certificate.getBasicConstraints()).isEqualTo(-1);
      assertThat(certificate.getNotBefore()).isEqualTo(Instant.parse("2026-11-28T11:55:00Z"));
      assertThat(certificate.getNotAfter()).isEqualTo(Instant.parse("2027-02-26T12:00:00Z"));
      assertThat(certificate.getExtensionValue("2.5.29.14")).as("key identifier").isNotNull();
      assertThat(certificate.getExtensionValue("2.5.29.35")).as("authority's").isNotNull();
      bundle.requireUsable("bundle", NOW);
    }
  }

  @Test
  void aRobotHasAKeyThatNeverEnds() throws Exception {
    try (Authority authority = open()) {
      IssuedBundle robot = authority.issue(MemberRole.ROBOT, "atrv1", DAYS_90);
      X509Certificate key = verified(robot).robotKey().orElseThrow().chain().get(0);
      assertThat(key.getSubjectX500Principal().getName()).isEqualTo("CN=atrv1 robot key");
      key.checkValidity(java.util.Date.from(Instant.parse("9999-01-01T00:00:00Z")));
      key.checkValidity(java.util.Date.from(Instant.EPOCH));
      key.verify(key.getPublicKey());
      assertThat(verified(authority.issue(MemberRole.OBSERVER, "ben", DAYS_90)).robotKey())
          .isEmpty();
    }
  }

  @Test
  void aKeyForCodeIsNoMember() throws Exception {
    try (Authority authority = open()) {
      IssuedCodeKey issued = authority.issueCode("release", DAYS_90);
      KeyEntry key =
          KeyEntry.read(issued.keyStore(), issued.passphrase().toCharArray(), "code", "code.p12");
      X509Certificate certificate = key.chain().get(0);
      assertThat(certificate.getExtendedKeyUsage()).containsExactly("1.3.6.1.5.5.7.3.3");
      assertThatThrownBy(
              () -> TeamCertificates.member(key.chain(), authority.certificate(), "code.p12"))
          .isInstanceOf(IdentityException.class)
          .hasMessageContaining("is not for connections of a member");
      assertThatThrownBy(() -> Member.of(certificate.getSubjectX500Principal()))
          .isInstanceOf(IllegalArgumentException.class);
    }
  }

  @Test
  void serialsAndPassphrasesAreNeverTheSame() throws Exception {
    Set<String> serials = new HashSet<>();
    Set<String> passphrases = new HashSet<>();
    try (Authority authority = open()) {
      for (int i = 0; i < 5; i++) {
        IssuedBundle issued = authority.issue(MemberRole.OPERATOR, "anna", DAYS_90);
        serials.add(issued.certificate().serial());
        passphrases.add(issued.passphrase());
        assertThat(new BigInteger(issued.certificate().serial(), 16).bitLength())
            .isGreaterThanOrEqualTo(64);
      }
    }
    assertThat(serials).hasSize(5);
    assertThat(passphrases).hasSize(5);
  }

  @Test
  void noCertificateOutlivesTheAuthority() throws Exception {
    try (Authority authority = open()) {
      IssuedBundle issued = authority.issue(MemberRole.OPERATOR, "anna", Duration.ofDays(99_999));
      assertThat(verified(issued).certificate().getNotAfter())
          .isEqualTo(authority.certificate().getNotAfter());
    }
  }

  @Test
  void revokesAllCertificatesOfAMember() throws Exception {
    try (Authority authority = open()) {
      VerifiedBundle first = verified(authority.issue(MemberRole.ROBOT, "atrv1", DAYS_90));
      VerifiedBundle renewed = verified(authority.issue(MemberRole.ROBOT, "atrv1", DAYS_90));
      VerifiedBundle other = verified(authority.issue(MemberRole.ROBOT, "atrv2", DAYS_90));
      List<IssuedCertificate> revoked =
          authority.revoke(each -> each.name().equals("atrv1"), "stolen");
      assertThat(revoked).hasSize(2).allMatch(each -> "stolen".equals(each.reason()));
      assertThat(list().isRevoked(first.certificate())).isTrue();
      assertThat(list().isRevoked(renewed.certificate())).isTrue();
      assertThat(list().isRevoked(other.certificate())).isFalse();
      assertThat(authority.revocationNumber()).isEqualTo(BigInteger.TWO);
      assertThat(authority.revoke(each -> each.name().equals("atrv1"), "again")).isEmpty();
      assertThat(authority.revocationNumber()).as("nothing is new").isEqualTo(BigInteger.TWO);
      VerifiedBundle again = verified(authority.issue(MemberRole.ROBOT, "atrv1", DAYS_90));
      again.requireUsable("bundle", NOW);
    }
  }

  /** A member whose certificate has expired may still stop robots; a revoked one may not. */
  @Test
  void anExpiredCertificateIsRevokedTooAndStaysInTheList() throws Exception {
    VerifiedBundle old;
    try (Authority authority = open()) {
      old = verified(authority.issue(MemberRole.OPERATOR, "anna", Duration.ofDays(1)));
    }
    Clock later = Clock.offset(CLOCK, Duration.ofDays(500));
    try (Authority authority = Authority.open(folder, () -> "secret", later)) {
      assertThat(authority.revoke(each -> true, "left")).hasSize(1);
    }
    assertThat(list().isRevoked(old.certificate())).isTrue();
  }

  /** The computer failed between the register and the list. */
  @Test
  void theListFollowsTheRegisterAfterAFailure() throws Exception {
    byte[] before = Files.readAllBytes(folder.resolve("revoked.crl"));
    VerifiedBundle robot;
    try (Authority authority = open()) {
      robot = verified(authority.issue(MemberRole.ROBOT, "atrv1", DAYS_90));
      authority.revoke(each -> true, "stolen");
    }
    Files.write(folder.resolve("revoked.crl"), before);
    try (Authority authority = open()) {
      assertThat(list().isRevoked(robot.certificate())).isTrue();
      assertThat(authority.revocationNumber())
          .as("number 2 may be known to robots already")
          .isEqualTo(BigInteger.valueOf(3));
    }
  }

  /** The computer failed after the number was written and before the list was. */
  @Test
  void noTwoListsHaveTheSameNumber() throws Exception {
    Files.writeString(folder.resolve("revoked.number"), "41\n");
    try (Authority authority = open()) {
      authority.issue(MemberRole.ROBOT, "atrv1", DAYS_90);
      authority.revoke(each -> true, "stolen");
      assertThat(authority.revocationNumber()).isEqualTo(BigInteger.valueOf(42));
    }
    Files.delete(folder.resolve("revoked.crl"));
    try (Authority authority = open()) {
      assertThat(authority.revocationNumber()).isEqualTo(BigInteger.valueOf(43));
    }
    Files.writeString(folder.resolve("revoked.number"), "many");
    Files.delete(folder.resolve("revoked.crl"));
    assertThatThrownBy(this::open)
        .isInstanceOf(AuthorityException.class)
        .hasMessageStartingWith(folder.resolve("revoked.number") + " has no number");
  }

  @Test
  void theRegisterNamesTheLineThatIsDamaged() throws Exception {
    try (Authority authority = open()) {
      authority.issue(MemberRole.ROBOT, "atrv1", DAYS_90);
    }
    Path register = folder.resolve("issued.jsonl");
    String whole = Files.readString(register);
    Files.writeString(register, whole + whole.substring(0, 40) + "\n");
    assertThatThrownBy(() -> Authority.issued(folder))
        .isInstanceOf(AuthorityException.class)
        .hasMessageStartingWith(register + ":2: this line is no certificate")
        .hasMessageNotContaining("\n");
  }

  @Test
  void thePassphraseIsNeeded() {
    assertThatThrownBy(() -> Authority.open(folder, () -> "guessed", CLOCK))
        .isInstanceOf(AuthorityException.class)
        .hasMessage("the passphrase of %s is wrong", folder.resolve("authority.p12"));
    assertThatThrownBy(() -> Authority.open(temp.resolve("none"), () -> "secret", CLOCK))
        .isInstanceOf(AuthorityException.class)
        .hasMessageContaining("there is no authority in " + temp.resolve("none"));
  }

  @Test
  void thePassphraseIsStoredBesideTheKeyOnlyIfAsked() throws Exception {
    Path stored = temp.resolve("stored");
    Authority.create(stored, "field", "secret", true, CLOCK);
    Authority.open(stored, () -> "guessed", CLOCK).close();
    Files.setPosixFilePermissions(
        stored.resolve("authority.pass"), PosixFilePermissions.fromString("rw-r--r--"));
    assertThatThrownBy(() -> Authority.open(stored, () -> "secret", CLOCK))
        .isInstanceOf(IOException.class)
        .hasMessageContaining("chmod 600");
  }

  @Test
  void twoCommandsDoNotUseItAtTheSameTime() throws Exception {
    try (Authority authority = open()) {
      assertThat(authority.issued()).isEmpty();
      assertThatThrownBy(this::open)
          .isInstanceOf(AuthorityException.class)
          .hasMessage(
              "another command uses the authority in %s now; repeat this when it has ended",
              folder);
    }
    open().close();
  }

  @Test
  void anAuthorityIsNeverReplaced() {
    assertThatThrownBy(() -> Authority.create(folder, "other", "secret", false, CLOCK))
        .isInstanceOf(AuthorityException.class)
        .hasMessageStartingWith(folder + " exists already");
    assertThatThrownBy(
            () -> Authority.create(temp.resolve("new"), "no team", "secret", false, CLOCK))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageContaining(Member.NAME_RULE);
    assertThat(temp.resolve("new")).doesNotExist();
  }

  @Test
  void aTeamBeginsWithThePolicyThatComesWithDfraAndMayChangeIt() throws Exception {
    Path policy = folder.resolve("policy.xml");
    try (Authority authority = open()) {
      VerifiedBundle bundle = verified(authority.issue(MemberRole.OPERATOR, "anna", DAYS_90));
      assertThat(bundle.policy().orElseThrow()).hasToString("policy 1 of field");
      assertThat(folder.resolve("policy.sig")).exists();
      Files.writeString(policy, BuiltInPolicies.standardText("field", 7));
      bundle = verified(authority.issue(MemberRole.OPERATOR, "anna", DAYS_90));
      assertThat(bundle.policy().orElseThrow().version()).isEqualTo(7);
      Files.delete(policy);
      bundle = verified(authority.issue(MemberRole.OPERATOR, "anna", DAYS_90));
      assertThat(bundle.policy()).isEmpty();
    }
  }

  @Test
  void aPolicyWithAFaultIsNotSigned() throws Exception {
    Path policy = folder.resolve("policy.xml");
    try (Authority authority = open()) {
      Files.writeString(policy, BuiltInPolicies.standardText("other", 2));
      assertThatThrownBy(() -> authority.issue(MemberRole.OPERATOR, "anna", DAYS_90))
          .isInstanceOf(ConfigurationException.class)
          .hasMessageMatching(
              "\\Q" + policy + "\\E:\\d+: the policy is of team other and not of field; .*");
      Files.writeString(
          policy,
          BuiltInPolicies.standardText("field", 2)
              .replace("interface=\"Registrar\"", "interface=\"Registry\""));
      assertThatThrownBy(() -> authority.issue(MemberRole.OPERATOR, "anna", DAYS_90))
          .isInstanceOf(ConfigurationException.class)
          .hasMessageContaining(policy + ":")
          .hasMessageContaining("Registry");
      assertThat(authority.issued()).isEmpty();
    }
  }
}
