package org.dfra.core.policy;

import java.nio.charset.StandardCharsets;
import java.security.GeneralSecurityException;
import java.security.PrivateKey;
import java.security.Signature;
import java.security.cert.X509Certificate;
import java.security.interfaces.ECPublicKey;
import java.util.Base64;

/**
 * A policy and its signature by the team's authority. The signature is SHA256withECDSA over the
 * bytes of the policy, in base64.
 */
public final class PolicyBundle {

  /** The longest signature in bytes of its text; that of a P-521 key has 186. */
  public static final int MAX_SIGNATURE = 512;

  private static final String ALGORITHM = "SHA256withECDSA";

  private final byte[] policy;
  private final String signature;

  private PolicyBundle(byte[] policy, String signature) {
    this.policy = policy.clone();
    this.signature = signature;
  }

  /**
   * A bundle that was received or stored; it is not verified yet.
   *
   * @param policy the bytes of the policy's XML
   * @param signature in base64; surrounding blanks are ignored
   */
  public static PolicyBundle of(byte[] policy, byte[] signature) {
    return new PolicyBundle(policy, new String(signature, StandardCharsets.US_ASCII).strip());
  }

  /**
   * Signs a policy.
   *
   * @param authority the private key of the team's authority, of an elliptic curve
   * @throws GeneralSecurityException if the key is of another kind
   */
  public static PolicyBundle sign(byte[] policy, PrivateKey authority)
      throws GeneralSecurityException {
    Signature signer = Signature.getInstance(ALGORITHM);
    signer.initSign(authority);
    signer.update(policy);
    return new PolicyBundle(policy, Base64.getEncoder().encodeToString(signer.sign()));
  }

  /** The bytes of the policy's XML. */
  public byte[] policy() {
    return policy.clone();
  }

  /** The signature, as it is written into a file. */
  public byte[] signature() {
    return (signature + "\n").getBytes(StandardCharsets.US_ASCII);
  }

  /**
   * Checks the size and the signature.
   *
   * @param authority the certificate of the team's authority
   * @throws PolicySignatureException if the authority has not signed this policy
   */
  public void verify(X509Certificate authority) throws PolicySignatureException {
    String by = authority.getSubjectX500Principal().getName();
    if (policy.length > PolicyXml.MAX_BYTES || signature.length() > MAX_SIGNATURE) {
      throw new PolicySignatureException(
          "the policy has "
              + policy.length
              + " bytes and its signature "
              + signature.length()
              + ", at most "
              + PolicyXml.MAX_BYTES
              + " and "
              + MAX_SIGNATURE
              + " are read; get it from the authority again");
    }
    if (!(authority.getPublicKey() instanceof ECPublicKey key)) {
      throw new PolicySignatureException(
          "the key of "
              + by
              + " is of "
              + authority.getPublicKey().getAlgorithm()
              + " and signs no policy; give the certificate of the team's authority");
    }
    try {
      byte[] decoded = Base64.getDecoder().decode(signature);
      boolean isCanonical = Base64.getEncoder().encodeToString(decoded).equals(signature);
      Signature verifier = Signature.getInstance(ALGORITHM);
      verifier.initVerify(key);
      verifier.update(policy);
      if (verifier.verify(decoded) && isCanonical) {
        return;
      }
    } catch (GeneralSecurityException | IllegalArgumentException e) {
      throw new PolicySignatureException(refusal(by), e);
    }
    throw new PolicySignatureException(refusal(by));
  }

  private static String refusal(String authority) {
    return "the policy's signature is not that of "
        + authority
        + " for these bytes; have the authority sign the policy again";
  }
}
