package org.dfra.river.security;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayInputStream;
import java.security.cert.CertificateFactory;
import java.security.cert.X509CRL;
import java.security.cert.X509Certificate;
import java.time.Clock;
import java.time.Duration;
import java.time.Instant;
import java.time.ZoneOffset;
import java.util.List;
import java.util.Optional;
import javax.security.auth.x500.X500Principal;
import org.bouncycastle.asn1.x509.KeyPurposeId;
import org.dfra.river.fixture.TestTeam;
import org.dfra.river.fixture.TestTeam.Issued;
import org.dfra.river.identity.RevokedCertificates;
import org.dfra.security.Member;
import org.dfra.security.MemberRole;
import org.junit.jupiter.api.Test;

/** Only a key that the team's authority has issued for code, and nothing else, signs code. */
class TeamCodeTest {

  private static final X500Principal RELEASE = new X500Principal("CN=release,OU=code,O=field");

  private final TestTeam team = new TestTeam("field");
  private final RevokedCertificates revoked = new RevokedCertificates(team.authority());
  private final Instant now = Instant.now();
  private final Issued release = code(team, KeyPurposeId.id_kp_codeSigning);

  private Issued code(TestTeam by, KeyPurposeId... purposes) {
    return by.issue(
        RELEASE, now.minus(Duration.ofHours(1)), now.plus(Duration.ofDays(1)), purposes);
  }

  private Optional<String> refusal(Instant at, X509Certificate... chain) {
    return new TeamCode(team.authority(), revoked, Clock.fixed(at, ZoneOffset.UTC))
        .refusal(List.of(chain));
  }

  @Test
  void aKeyForCodeSignsWithAndWithoutTheAuthoritysCertificateBesideIt() {
    assertThat(refusal(now, release.certificate())).isEmpty();
    assertThat(refusal(now, release.certificate(), team.authority())).isEmpty();
  }

  @Test
  void otherKeysOfTheTeamDoNot() {
    String other = "the authority of this team has not issued for code";
    Issued robot = team.issue(new Member("field", MemberRole.ROBOT, "atrv1"));
    assertThat(refusal(now, robot.certificate()).orElseThrow()).startsWith(other);
    Issued both = code(team, KeyPurposeId.id_kp_codeSigning, KeyPurposeId.id_kp_clientAuth);
    assertThat(refusal(now, both.certificate()).orElseThrow()).startsWith(other);
    assertThat(refusal(now, code(team).certificate()).orElseThrow()).startsWith(other);
    assertThat(refusal(now, team.authority()).orElseThrow()).startsWith(other);
  }

  @Test
  void aTeamOfTheSameNameHasOtherKeys() {
    TestTeam others = new TestTeam("field");
    Issued theirs = code(others, KeyPurposeId.id_kp_codeSigning);
    assertThat(refusal(now, theirs.certificate())).isPresent();
    assertThat(refusal(now, theirs.certificate(), others.authority())).isPresent();
    assertThat(refusal(now, theirs.certificate(), team.authority())).isPresent();
  }

  @Test
  void aRevokedKeySignsNothing() throws Exception {
    byte[] list = team.revocations(2, release.certificate());
    assertThat(
            revoked.replace(
                (X509CRL)
                    CertificateFactory.getInstance("X.509")
                        .generateCRL(new ByteArrayInputStream(list))))
        .isTrue();
    assertThat(refusal(now, release.certificate()).orElseThrow())
        .startsWith("the authority of this team has revoked");
  }

  @Test
  void aKeySignsNothingBeforeAndAfterItsDates() {
    String dates = "is valid only from ";
    assertThat(refusal(now.minus(Duration.ofHours(2)), release.certificate()).orElseThrow())
        .startsWith(dates);
    assertThat(refusal(now.plus(Duration.ofDays(2)), release.certificate()).orElseThrow())
        .startsWith(dates);
  }
}
