package org.dfra.authority;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.math.BigInteger;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.time.Clock;
import java.time.Duration;
import java.time.Instant;
import java.util.HashMap;
import java.util.Map;
import java.util.TreeMap;
import org.dfra.authority.Authority.IssuedBundle;
import org.dfra.cli.security.Bundle;
import org.dfra.cli.security.IdentityInstaller;
import org.dfra.cli.security.VerifiedBundle;
import org.dfra.core.policy.BuiltInPolicies;
import org.dfra.river.identity.IdentityException;
import org.dfra.river.identity.IdentityFolder;
import org.dfra.river.identity.SignedFiles;
import org.dfra.river.identity.TeamCredentials;
import org.dfra.security.Member;
import org.dfra.security.MemberRole;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.ExtendWith;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** From a bundle to the folder of an identity: all of it, or nothing. */
@ExtendWith(QuickKeyStores.class)
class JoinTest {

  private static final Duration DAY = Duration.ofDays(1);

  @TempDir Path temp;

  private Path state;
  private Path folder;
  private IdentityInstaller installer;

  @BeforeEach
  void create() throws IOException {
    state = temp.resolve("state");
    folder = state.resolve("security");
    installer = new IdentityInstaller(state);
    Authority.create(temp.resolve("field"), "field", "secret", false, Clock.systemUTC());
  }

  private IssuedBundle issue(String authority, MemberRole role, String name) throws IOException {
    try (Authority opened =
        Authority.open(temp.resolve(authority), () -> "secret", Clock.systemUTC())) {
      return opened.issue(role, name, DAY);
    }
  }

  private static VerifiedBundle verified(IssuedBundle issued) throws IdentityException {
    return VerifiedBundle.open(issued.bundle(), issued.passphrase(), "a.bundle");
  }

  private void join(IssuedBundle issued) throws Exception {
    installer.install(verified(issued), "a.bundle", Instant.now(), false);
  }

  private void assertRefused(IssuedBundle issued, Instant now, String... parts) {
    assertThatThrownBy(() -> installer.install(verified(issued), "a.bundle", now, false))
        .isInstanceOf(IdentityException.class)
        .hasMessageContainingAll(parts)
        .hasMessageNotContaining("\n");
  }

  private Map<String, String> contents() throws IOException {
    Map<String, String> contents = new TreeMap<>();
    try (var files = Files.walk(state)) {
      for (Path each : files.filter(Files::isRegularFile).toList()) {
        contents.put(
            state.relativize(each).toString(),
            java.util.Base64.getEncoder().encodeToString(Files.readAllBytes(each)));
      }
    }
    return contents;
  }

  @Test
  void whatIsJoinedIsLoaded() throws Exception {
    join(issue("field", MemberRole.ROBOT, "atrv1"));
    TeamCredentials loaded = IdentityFolder.load(folder);
    assertThat(loaded.member()).isEqualTo(new Member("field", MemberRole.ROBOT, "atrv1"));
    assertThat(loaded.robotKey()).isPresent();
    assertThat(loaded.validityFault(Instant.now())).isEmpty();
    assertThat(PosixFilePermissions.toString(Files.getPosixFilePermissions(folder)))
        .isEqualTo("rwx------");
    assertThat(contents().keySet())
        .containsExactly(
            "security/authority.pem",
            "security/identity.p12",
            "security/identity.pass",
            "security/policy.sig",
            "security/policy.xml",
            "security/revoked.crl",
            "security/robot.p12",
            "security/robot.pass");
    for (String each : contents().keySet()) {
      assertThat(PosixFilePermissions.toString(Files.getPosixFilePermissions(state.resolve(each))))
          .as(each)
          .isEqualTo("rw-------");
    }
  }

  @Test
  void theOneTimePassphraseIsNotKept() throws Exception {
    IssuedBundle issued = issue("field", MemberRole.OPERATOR, "anna");
    join(issued);
    assertThat(Files.readString(folder.resolve("identity.pass")))
        .doesNotContain(issued.passphrase());
  }

  @Test
  void aRenewedBundleOfTheSameMemberNeedsNoForceAndKeepsTheRobotsKey() throws Exception {
    join(issue("field", MemberRole.ROBOT, "atrv1"));
    TeamCredentials before = IdentityFolder.load(folder);
    join(issue("field", MemberRole.ROBOT, "atrv1"));
    TeamCredentials after = IdentityFolder.load(folder);
    assertThat(after.certificate()).isNotEqualTo(before.certificate());
    assertThat(after.robotKey().orElseThrow().certificate())
        .isEqualTo(before.robotKey().orElseThrow().certificate());
    assertThat(state).as("nothing is left").isDirectoryNotContaining("glob:**.old");
  }

  @Test
  void anotherMemberNeedsForce() throws Exception {
    join(issue("field", MemberRole.ROBOT, "atrv1"));
    Map<String, String> before = contents();
    IssuedBundle other = issue("field", MemberRole.ROBOT, "atrv2");
    assertRefused(
        other,
        Instant.now(),
        "this computer is robot atrv1 of field, and the bundle is of robot atrv2 of field",
        "--force");
    assertThat(contents()).isEqualTo(before);
    installer.install(verified(other), "a.bundle", Instant.now(), true);
    assertThat(IdentityFolder.load(folder).member().name()).isEqualTo("atrv2");
  }

  @Test
  void anotherTeamOrAnotherAuthorityOfTheSameNameNeedsForce() throws Exception {
    join(issue("field", MemberRole.ROBOT, "atrv1"));
    Authority.create(temp.resolve("other"), "other", "secret", false, Clock.systemUTC());
    assertRefused(issue("other", MemberRole.ROBOT, "atrv1"), Instant.now(), "atrv1 of other");
    Authority.create(temp.resolve("namesake"), "field", "secret", false, Clock.systemUTC());
    assertRefused(
        issue("namesake", MemberRole.ROBOT, "atrv1"),
        Instant.now(),
        "already, by another authority");
  }

  @Test
  void aClockBeforeTheCertificateIsSaid() throws Exception {
    IssuedBundle issued = issue("field", MemberRole.ROBOT, "atrv1");
    assertRefused(
        issued,
        Instant.parse("1970-01-01T00:00:30Z"),
        "the certificate of robot atrv1 of field in a.bundle is valid from ",
        "this computer's clock says 1970-01-01T00:00:30Z; set the clock");
    assertThat(state).doesNotExist();
  }

  @Test
  void anExpiredBundleIsRefused() throws Exception {
    IssuedBundle issued = issue("field", MemberRole.ROBOT, "atrv1");
    assertRefused(issued, Instant.now().plus(Duration.ofDays(2)), " expired at ", "security renew");
  }

  @Test
  void aRevokedBundleIsRefused() throws Exception {
    IssuedBundle issued = issue("field", MemberRole.ROBOT, "atrv1");
    byte[] list;
    try (Authority authority =
        Authority.open(temp.resolve("field"), () -> "secret", Clock.systemUTC())) {
      authority.revoke(each -> true, "stolen");
      list = authority.revocations();
    }
    IssuedBundle revoked = with(issued, "revoked.crl", list);
    assertRefused(
        revoked, Instant.now(), "the authority has revoked the certificate of robot atrv1");
  }

  /** An old bundle does not bring a revoked member back. */
  @Test
  void aNewerListOfRevokedCertificatesStays() throws Exception {
    IssuedBundle first = issue("field", MemberRole.OPERATOR, "anna");
    join(first);
    try (Authority authority =
        Authority.open(temp.resolve("field"), () -> "secret", Clock.systemUTC())) {
      authority.issue(MemberRole.ROBOT, "atrv1", DAY);
      authority.revoke(each -> each.name().equals("atrv1"), "stolen");
      Files.write(folder.resolve("revoked.crl"), authority.revocations());
    }
    join(first);
    assertThat(IdentityFolder.load(folder).revocations().flatMap(SignedFiles::number))
        .contains(BigInteger.TWO);
  }

  /** Members pass newer policies on, so a bundle may have an older one. */
  @Test
  void aNewerPolicyStays() throws Exception {
    IssuedBundle first = issue("field", MemberRole.OPERATOR, "anna");
    join(first);
    Files.writeString(temp.resolve("field/policy.xml"), BuiltInPolicies.standardText("field", 5));
    IssuedBundle renewed = issue("field", MemberRole.OPERATOR, "anna");
    join(renewed);
    join(first);
    assertThat(verified(first).policy().orElseThrow().version()).isEqualTo(1);
    assertThat(Files.readString(folder.resolve("policy.xml"))).contains("version=\"5\"");
    assertThat(Files.readAllBytes(folder.resolve("policy.sig")))
        .isEqualTo(renewed.bundle().file("policy.sig").orElseThrow());
    Files.writeString(folder.resolve("policy.xml"), "damaged");
    join(first);
    assertThat(Files.readString(folder.resolve("policy.xml"))).contains("version=\"1\"");
  }

  @Test
  void aJaasConfigurationOfTheUsersOwnStays() throws Exception {
    IssuedBundle issued = issue("field", MemberRole.OPERATOR, "anna");
    join(issued);
    String own =
        "dfra { com.sun.security.auth.module.KeyStoreLoginModule required keyStoreType=\"PKCS12\""
            + " keyStoreURL=\""
            + folder.resolve("identity.p12").toUri()
            + "\"; };";
    Files.writeString(folder.resolve("jaas.conf"), own);
    join(issued);
    assertThat(folder.resolve("jaas.conf")).hasContent(own);
    assertThat(IdentityFolder.load(folder).member().name()).isEqualTo("anna");
  }

  @Test
  void anIdentityThatCannotBeReadNeedsForce() throws Exception {
    IssuedBundle issued = issue("field", MemberRole.ROBOT, "atrv1");
    join(issued);
    Files.delete(folder.resolve("authority.pem"));
    Map<String, String> before = contents();
    assertRefused(
        issued,
        Instant.now(),
        "cannot be read, so nothing is replaced",
        "authority.pem",
        "--force");
    assertThat(contents()).isEqualTo(before);
    installer.install(verified(issued), "a.bundle", Instant.now(), true);
    assertThat(IdentityFolder.load(folder).member().name()).isEqualTo("atrv1");
  }

  @Test
  void anInterruptedJoinIsUndoneByTheNext() throws Exception {
    join(issue("field", MemberRole.ROBOT, "atrv1"));
    Files.move(folder, IdentityFolder.replaced(folder));
    assertRefused(
        issue("field", MemberRole.ROBOT, "atrv2"), Instant.now(), "this computer is robot atrv1");
    assertThat(IdentityFolder.load(folder).member().name()).isEqualTo("atrv1");
  }

  @Test
  void aWrongPassphraseIsSaid() throws Exception {
    IssuedBundle issued = issue("field", MemberRole.ROBOT, "atrv1");
    assertThatThrownBy(() -> VerifiedBundle.open(issued.bundle(), "guessed", "a.bundle"))
        .isInstanceOf(IdentityException.class)
        .hasMessage("the passphrase of a.bundle (identity.p12) is wrong");
  }

  private static IssuedBundle with(IssuedBundle issued, String name, byte[] content) {
    Map<String, byte[]> files = new HashMap<>();
    for (String each :
        new String[] {
          "identity.p12", "robot.p12", "authority.pem", "revoked.crl", "policy.xml", "policy.sig"
        }) {
      issued.bundle().file(each).ifPresent(there -> files.put(each, there));
    }
    files.put(name, content);
    return new IssuedBundle(Bundle.of(files), issued.passphrase(), issued.certificate());
  }

  /** Each file of a bundle, exchanged for that of another team. */
  @ParameterizedTest
  @ValueSource(strings = {"authority.pem", "revoked.crl", "policy.xml", "policy.sig"})
  void aFileOfAnotherAuthorityIsRefused(String name) throws Exception {
    Authority.create(temp.resolve("other"), "field", "secret", false, Clock.systemUTC());
    Files.writeString(temp.resolve("other/policy.xml"), BuiltInPolicies.standardText("field", 2));
    IssuedBundle own = issue("field", MemberRole.ROBOT, "atrv1");
    IssuedBundle foreign = issue("other", MemberRole.ROBOT, "atrv1");
    IssuedBundle mixed = with(own, name, foreign.bundle().file(name).orElseThrow());
    assertThatThrownBy(() -> verified(mixed))
        .isInstanceOf(IdentityException.class)
        .hasMessageContaining("a.bundle (");
    assertThat(verified(own).member()).isEqualTo(verified(foreign).member());
  }

  @ParameterizedTest
  @ValueSource(strings = {"identity.p12", "robot.p12", "revoked.crl"})
  void aDamagedFileIsNamed(String name) throws Exception {
    IssuedBundle own = issue("field", MemberRole.ROBOT, "atrv1");
    byte[] damaged = own.bundle().file(name).orElseThrow();
    damaged[damaged.length / 2] ^= 1;
    assertThatThrownBy(() -> verified(with(own, name, damaged)))
        .isInstanceOf(IdentityException.class)
        .hasMessageContaining("a.bundle (" + name + ")")
        .hasMessageNotContaining("\n");
  }
}
