package org.dfra.river.identity;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.junit.jupiter.api.Assumptions.assumeFalse;

import java.io.IOException;
import java.math.BigInteger;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.security.cert.X509CRL;
import java.time.Duration;
import java.time.Instant;
import java.util.List;
import javax.security.auth.x500.X500Principal;
import org.bouncycastle.asn1.x509.KeyPurposeId;
import org.dfra.river.fixture.TestTeam;
import org.dfra.river.fixture.TestTeam.Issued;
import org.dfra.security.Member;
import org.dfra.security.MemberRole;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** What a process proves that it is, and what is wrong with a folder from which it cannot. */
class IdentityFolderTest {

  private static final TestTeam TEAM = new TestTeam("field");
  private static final TestTeam OTHER = new TestTeam("field");
  private static final Member ROBOT = new Member("field", MemberRole.ROBOT, "atrv1");
  private static final Issued ISSUED = TEAM.issue(ROBOT);
  private static final Duration DAY = Duration.ofDays(1);

  @TempDir Path temp;

  private Path folder;

  @BeforeEach
  void join() throws IOException {
    folder = TEAM.writeIdentity(temp.resolve("security"), ISSUED);
  }

  private void assertRefused(String... parts) {
    assertThatThrownBy(() -> IdentityFolder.load(folder))
        .isInstanceOf(IdentityException.class)
        .hasMessageContainingAll(parts)
        .hasMessageNotContainingAny("\n", TestTeam.PASSPHRASE);
  }

  private Path file(String name) {
    return folder.resolve(name);
  }

  /** Another key and certificate in the same folder. */
  private void replace(Issued issued, List<java.security.cert.X509Certificate> chain)
      throws IOException {
    TestTeam.writePrivate(file("identity.p12"), TestTeam.keyStore("identity", issued, chain));
  }

  private void replace(Issued issued) throws IOException {
    replace(issued, List.of(issued.certificate(), TEAM.authority()));
  }

  @Test
  void loadsTheMemberItsKeyAndItsAuthority() throws Exception {
    TeamCredentials loaded = IdentityFolder.load(folder);
    assertThat(loaded.member()).isEqualTo(ROBOT);
    assertThat(loaded.privateKey()).isEqualTo(ISSUED.key());
    assertThat(loaded.chain()).containsExactly(ISSUED.certificate(), TEAM.authority());
    assertThat(loaded.authority()).isEqualTo(TEAM.authority());
    assertThat(loaded.robotKey()).isEmpty();
    assertThat(loaded.isRevoked()).isFalse();
    assertThat(loaded.revocations().flatMap(SignedFiles::number)).contains(BigInteger.ONE);
    assertThat(loaded.validity().at(Instant.now())).isEqualTo(CertificateValidity.Status.VALID);
    assertThat(loaded.validityFault(Instant.now())).isEmpty();
    assertThat(loaded.subject().isReadOnly()).isTrue();
    assertThat(loaded.subject().getPrincipals()).contains(ROBOT, ROBOT.x500());
    assertThat(loaded).hasToString("robot atrv1 of field (" + folder + ")");
  }

  @Test
  void isChangedByNobody() throws Exception {
    TeamCredentials loaded = IdentityFolder.load(folder);
    loaded.chain()[0] = TEAM.authority();
    assertThat(loaded.certificate()).isEqualTo(ISSUED.certificate());
    assertThatThrownBy(() -> loaded.subject().getPrincipals().clear())
        .isInstanceOf(IllegalStateException.class);
  }

  @Test
  void loadsARobotsOwnKey() throws Exception {
    Issued key = TestTeam.robotKey("atrv1");
    TestTeam.writeRobotKey(folder, key);
    TeamCredentials.RobotKey loaded = IdentityFolder.load(folder).robotKey().orElseThrow();
    assertThat(loaded.key()).isEqualTo(key.key());
    assertThat(loaded.certificate()).isEqualTo(key.certificate());
    assertThat(loaded).hasToString("CN=atrv1 robot key");
  }

  @Test
  void refusesTheKeyOfAnotherRobot() throws Exception {
    TestTeam.writeRobotKey(folder, TestTeam.robotKey("atrv2"));
    assertRefused(file("robot.p12") + "", "CN=atrv2 robot key", "not of CN=atrv1 robot key");
  }

  @Test
  void knowsThatItIsRevoked() throws Exception {
    Files.write(file("revoked.crl"), TEAM.revocations(2, ISSUED.certificate()));
    assertThat(IdentityFolder.load(folder).isRevoked()).isTrue();
  }

  @Test
  void loadsWithoutAListOfRevokedCertificates() throws Exception {
    Files.delete(file("revoked.crl"));
    assertThat(IdentityFolder.load(folder).revocations()).isEmpty();
  }

  @Test
  void anExpiredMemberIsLoadedAndSaysSo() throws Exception {
    Instant now = Instant.now();
    Instant until = now.minusSeconds(60).truncatedTo(java.time.temporal.ChronoUnit.SECONDS);
    replace(TEAM.issue(ROBOT.x500(), now.minus(Duration.ofHours(2)), until));
    TeamCredentials loaded = IdentityFolder.load(folder);
    assertThat(loaded.member()).isEqualTo(ROBOT);
    assertThat(loaded.validity().at(now)).isEqualTo(CertificateValidity.Status.EXPIRED);
    assertThat(loaded.validityFault(now))
        .contains(
            "the certificate of robot atrv1 of field in "
                + file("identity.p12")
                + " expired at "
                + until
                + " by this computer's clock, which says "
                + now
                + "; type \"security renew atrv1\" on the authority's computer and join the new"
                + " bundle");
  }

  @Test
  void aClockBeforeTheCertificateIsSaid() throws Exception {
    Instant early = Instant.parse("1970-01-01T00:01:00Z");
    TeamCredentials loaded = IdentityFolder.load(folder);
    assertThat(loaded.validity().at(early)).isEqualTo(CertificateValidity.Status.NOT_YET_VALID);
    assertThat(loaded.validityFault(early).orElseThrow())
        .contains("is valid from ", "clock says 1970-01-01T00:01:00Z; set the clock");
  }

  @Test
  void aCertificateIsValidNoLongerThanItsAuthority() throws Exception {
    replace(TEAM.issue(ROBOT.x500(), Instant.now(), Instant.now().plus(Duration.ofDays(9999))));
    assertThat(IdentityFolder.load(folder).validity().until())
        .isEqualTo(TEAM.authority().getNotAfter().toInstant());
  }

  @Test
  void aFolderThatIsMissingIsNotJoined() {
    folder = temp.resolve("elsewhere");
    assertThat(IdentityFolder.isJoined(folder)).isFalse();
    assertRefused(folder + " does not exist, so this computer has no identity of a team");
  }

  /** Else a robot would start open after a crash in a join. */
  @Test
  void anInterruptedJoinIsAJoin() throws Exception {
    Files.move(folder, IdentityFolder.replaced(folder));
    assertThat(IdentityFolder.isJoined(folder)).isTrue();
    assertThat(IdentityFolder.load(folder).member()).isEqualTo(ROBOT);
    TestTeam.writeRobotKey(IdentityFolder.replaced(folder), TestTeam.robotKey("atrv1"));
    assertThat(IdentityFolder.loadAlone(folder).key()).isNotNull();
    Files.writeString(folder, "a file");
    assertThat(IdentityFolder.load(folder).member()).isEqualTo(ROBOT);
  }

  @ParameterizedTest
  @ValueSource(strings = {"identity.p12", "authority.pem"})
  void aMissingFileIsNamed(String name) throws Exception {
    Files.delete(file(name));
    assertThat(IdentityFolder.isJoined(folder)).isTrue();
    assertRefused(file(name) + " is missing; join the team again: security join NAME.bundle");
  }

  @ParameterizedTest
  @ValueSource(strings = {"identity.p12", "identity.pass", "robot.p12", "robot.pass"})
  void aFileThatOthersMayReadIsRefused(String name) throws Exception {
    TestTeam.writeRobotKey(folder, TestTeam.robotKey("atrv1"));
    Files.setPosixFilePermissions(file(name), PosixFilePermissions.fromString("rw-r-----"));
    assertRefused("other users may use " + file(name), "type: chmod 600 " + file(name));
  }

  @Test
  void aFolderThatOthersMayEnterIsRefused() throws Exception {
    Files.setPosixFilePermissions(folder, PosixFilePermissions.fromString("rwxrwx---"));
    assertRefused("other users may use " + folder, "type: chmod 700 " + folder);
  }

  @Test
  void aFileThatCannotBeReadIsNamed() throws Exception {
    Files.setPosixFilePermissions(
        file("identity.p12"), PosixFilePermissions.fromString("-w-------"));
    assumeFalse(Files.isReadable(file("identity.p12")), "this user reads files of any mode");
    assertRefused(file("identity.p12") + " cannot be read", "run this as the user");
  }

  @Test
  void aFolderInPlaceOfAFileIsNamed() throws Exception {
    Files.delete(file("authority.pem"));
    Files.createDirectory(file("authority.pem"));
    assertRefused(file("authority.pem") + " cannot be read");
  }

  @Test
  void aWrongPassphraseIsSaid() throws Exception {
    TestTeam.writePrivate(file("identity.pass"), "another\n".getBytes());
    assertRefused(
        "the passphrase of " + file("identity.p12") + " is wrong; correct identity.pass beside it");
  }

  @Test
  void aMissingPassphraseIsAskedForOnTheTerminal() throws Exception {
    assumeFalse(System.console() != null, "this test has a terminal");
    Files.delete(file("identity.pass"));
    assertRefused(file("identity.pass") + " is missing, and there is no terminal");
  }

  @Test
  void bytesThatAreNoKeyStoreAreSaid() throws Exception {
    TestTeam.writePrivate(file("identity.p12"), "no key store".getBytes());
    assertRefused(file("identity.p12") + " is no key store in PKCS #12");
  }

  @Test
  void aFileThatIsTooLargeIsNotRead() throws Exception {
    TestTeam.writePrivate(
        file("identity.p12"), new byte[SecurityFiles.maxBytes("identity.p12") + 1]);
    assertRefused(file("identity.p12") + " has more than 262144 bytes");
  }

  @Test
  void aCertificateOfAnotherAuthorityIsRefused() throws Exception {
    Issued foreign = OTHER.issue(ROBOT);
    replace(foreign, List.of(foreign.certificate()));
    assertRefused(file("identity.p12") + "", "is not from the authority in authority.pem");
    replace(foreign, List.of(foreign.certificate(), OTHER.authority()));
    assertRefused(file("identity.p12") + " comes with that of another authority");
  }

  @Test
  void twoAuthoritiesAreRefused() throws Exception {
    Files.writeString(
        file("authority.pem"), TestTeam.pem(TEAM.authority()) + TestTeam.pem(OTHER.authority()));
    assertRefused(
        file("authority.pem") + " has the certificates of 2 authorities, but a team has one");
  }

  @ParameterizedTest
  @ValueSource(strings = {"", "no certificate"})
  void anAuthorityWithoutACertificateIsRefused(String text) throws Exception {
    Files.writeString(file("authority.pem"), text);
    assertRefused(file("authority.pem") + "", "join the team again");
  }

  @Test
  void aMemberIsNoAuthority() throws Exception {
    Files.writeString(file("authority.pem"), TestTeam.pem(ISSUED.certificate()));
    assertRefused(file("authority.pem") + "", "so it is no authority");
  }

  @Test
  void aCertificateForAnotherPurposeIsRefused() throws Exception {
    Instant now = Instant.now();
    for (KeyPurposeId each :
        List.of(
            KeyPurposeId.id_kp_codeSigning,
            KeyPurposeId.id_kp_serverAuth,
            KeyPurposeId.id_kp_clientAuth)) {
      replace(TEAM.issue(ROBOT.x500(), now.minus(DAY), now.plus(DAY), each));
      assertRefused("in " + file("identity.p12") + " is not for connections of a member");
    }
    replace(TEAM.issue(ROBOT.x500(), now.minus(DAY), now.plus(DAY), new KeyPurposeId[0]));
    assertRefused("is not for connections of a member");
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "CN=atrv1",
        "CN=atrv1,OU=robot,O=field,C=US",
        "CN=atrv1,OU=king,O=field",
        "CN=a b,OU=robot,O=field"
      })
  void aSubjectThatIsNoMemberIsRefused(String subject) throws Exception {
    Instant now = Instant.now();
    replace(TEAM.issue(new X500Principal(subject), now.minus(DAY), now.plus(DAY)));
    assertRefused("the certificate in " + file("identity.p12") + ": ");
  }

  @Test
  void aKeyThatIsNotTheCertificatesIsRefused() throws Exception {
    replace(new Issued(TEAM.issue(ROBOT).key(), ISSUED.certificate()));
    assertRefused(
        "the key in " + file("identity.p12") + " does not belong to the certificate beside it");
  }

  @Test
  void aListOfAnotherAuthorityIsRefused() throws Exception {
    Files.write(file("revoked.crl"), OTHER.revocations(1));
    assertRefused(file("revoked.crl") + " is not signed by the authority in authority.pem");
    Files.writeString(file("revoked.crl"), "no list");
    assertRefused(file("revoked.crl") + " is no list of revoked certificates");
  }

  @Test
  void numbersOfListsAreRead() throws Exception {
    for (long number : new long[] {0, 1, 127, 128, 255, 256, 1L << 40}) {
      X509CRL list =
          SignedFiles.revocations(TEAM.revocations(number), TEAM.authority(), "revoked.crl");
      assertThat(SignedFiles.number(list)).contains(BigInteger.valueOf(number));
    }
  }

  @Test
  void aJaasConfigurationOfTheUsersOwnReplacesTheDefaultOne() throws Exception {
    Files.writeString(
        file("jaas.conf"),
        """
        dfra {
          com.sun.security.auth.module.UnixLoginModule required;
          com.sun.security.auth.module.KeyStoreLoginModule required
            keyStoreType="PKCS12" keyStoreAlias="identity" keyStoreURL="%s";
        };
        """
            .formatted(file("identity.p12").toUri()));
    TeamCredentials loaded = IdentityFolder.load(folder);
    assertThat(loaded.member()).isEqualTo(ROBOT);
    assertThat(loaded.subject().getPrincipals())
        .anyMatch(each -> each.getClass().getSimpleName().equals("UnixPrincipal"));
  }

  @Test
  void aJaasConfigurationWithoutTheEntryIsRefused() throws Exception {
    Files.writeString(file("jaas.conf"), "other { a.B required; };");
    assertRefused(file("jaas.conf") + " has no entry \"dfra\"");
    Files.writeString(file("jaas.conf"), "dfra { a.B");
    assertRefused(file("jaas.conf") + " is no configuration of JAAS");
    Files.writeString(file("jaas.conf"), "dfra { a.B required; };");
    assertRefused("the login that " + file("jaas.conf") + " describes failed", "a.B");
    Files.writeString(
        file("jaas.conf"), "dfra { com.sun.security.auth.module.UnixLoginModule required; };");
    assertRefused(file("jaas.conf") + " describes gave 0 keys with certificates instead of one");
  }
}
