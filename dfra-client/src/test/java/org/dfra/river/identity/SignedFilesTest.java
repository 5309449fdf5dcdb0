package org.dfra.river.identity;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.charset.StandardCharsets;
import java.security.Signature;
import java.util.Base64;
import org.dfra.river.fixture.TestTeam;
import org.dfra.river.fixture.TestTeam.Issued;
import org.dfra.security.Member;
import org.dfra.security.MemberRole;
import org.junit.jupiter.api.Test;

/** Signatures over policies, and fingerprints. */
class SignedFilesTest {

  private static final byte[] POLICY = "<policy/>".getBytes(StandardCharsets.UTF_8);

  private final TestTeam team = new TestTeam("field");

  /** A member's certificate stands for that of the authority, whose key the fixture keeps. */
  private final Issued signer = team.issue(new Member("field", MemberRole.OPERATOR, "anna"));

  private byte[] signature() throws Exception {
    Signature signature = Signature.getInstance("SHA256withECDSA");
    signature.initSign(signer.key());
    signature.update(POLICY);
    return Base64.getEncoder().encode(signature.sign());
  }

  @Test
  void aSignedPolicyIsAccepted() throws Exception {
    SignedFiles.requirePolicySignature(POLICY, signature(), signer.certificate(), "policy.xml");
  }

  @Test
  void aChangedPolicyIsRefused() throws Exception {
    byte[] signature = signature();
    byte[] changed = "<Policy/>".getBytes(StandardCharsets.UTF_8);
    assertThatThrownBy(
            () ->
                SignedFiles.requirePolicySignature(
                    changed, signature, signer.certificate(), "policy.xml"))
        .isInstanceOf(IdentityException.class)
        .hasMessageStartingWith("policy.xml is not signed by the authority in authority.pem");
    assertThatThrownBy(
            () ->
                SignedFiles.requirePolicySignature(
                    POLICY, signature, team.authority(), "policy.xml"))
        .isInstanceOf(IdentityException.class);
  }

  @Test
  void aSignatureThatIsNoneIsRefused() {
    for (String text : new String[] {"", "?", "AAAA"}) {
      assertThatThrownBy(
              () ->
                  SignedFiles.requirePolicySignature(
                      POLICY, text.getBytes(StandardCharsets.UTF_8), signer.certificate(), "p"))
          .isInstanceOf(IdentityException.class)
          .hasMessageContaining("the signature of p cannot be read");
    }
  }

  @Test
  void aFingerprintHasThirtyTwoPairs() {
    assertThat(CertificateFingerprint.sha256(team.authority()))
        .matches("[0-9A-F]{2}(:[0-9A-F]{2}){31}");
  }
}
