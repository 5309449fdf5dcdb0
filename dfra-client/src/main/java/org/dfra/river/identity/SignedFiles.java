package org.dfra.river.identity;

import java.io.ByteArrayInputStream;
import java.math.BigInteger;
import java.nio.charset.StandardCharsets;
import java.security.GeneralSecurityException;
import java.security.Signature;
import java.security.cert.CRLException;
import java.security.cert.CertificateFactory;
import java.security.cert.X509CRL;
import java.security.cert.X509Certificate;
import java.util.Base64;
import java.util.Optional;

/** Checks of what the authority signs beside certificates: the list of revoked ones, the policy. */
public final class SignedFiles {

  private static final String AGAIN = "; join the team again: security join NAME.bundle";
  private static final String CRL_NUMBER = "2.5.29.20"; // RFC 5280, 5.2.3
  private static final int OCTET_STRING = 4;
  private static final int INTEGER = 2;
  private static final int HEADER = 2; // tag and length of a short DER value

  private SignedFiles() {}

  /**
   * Reads the list of revoked certificates.
   *
   * @param bytes the file, in DER or PEM
   * @param file its name, for messages
   * @throws IdentityException if it is no list, has no number, or the authority has not signed it
   */
  public static X509CRL revocations(byte[] bytes, X509Certificate authority, String file)
      throws IdentityException {
    X509CRL list;
    try {
      list =
          (X509CRL)
              CertificateFactory.getInstance("X.509").generateCRL(new ByteArrayInputStream(bytes));
    } catch (CRLException e) {
      throw new IdentityException(
          file + " is no list of revoked certificates (" + e + ")" + AGAIN, e);
    } catch (GeneralSecurityException e) {
      throw new IllegalStateException("every JDK reads X.509", e);
    }
    try {
      list.verify(authority.getPublicKey());
    } catch (GeneralSecurityException e) {
      throw new IdentityException(
          file
              + " is not signed by the authority in "
              + SecurityFiles.AUTHORITY
              + " ("
              + e
              + ")"
              + AGAIN,
          e);
    }
    if (number(list).isEmpty()) {
      throw new IdentityException(
          file + " has no number, so it is not known whether it is newer than another" + AGAIN);
    }
    return list;
  }

  /**
   * The number of a list: a list with a higher number replaces one with a lower.
   *
   * @return empty if it has none
   */
  public static Optional<BigInteger> number(X509CRL list) {
    byte[] extension = list.getExtensionValue(CRL_NUMBER);
    if (extension == null
        || extension.length <= 2 * HEADER
        || extension[0] != OCTET_STRING
        || extension[1] != extension.length - HEADER
        || extension[HEADER] != INTEGER
        || extension[HEADER + 1] != extension.length - 2 * HEADER) {
      return Optional.empty();
    }
    BigInteger number = new BigInteger(extension, 2 * HEADER, extension.length - 2 * HEADER);
    return Optional.of(number).filter(each -> each.signum() >= 0);
  }

  /**
   * Checks the authority's signature over a policy.
   *
   * @param signature the file, in Base64
   * @param file the policy's name, for messages
   * @throws IdentityException if the signature is not the authority's over these bytes
   */
  public static void requirePolicySignature(
      byte[] policy, byte[] signature, X509Certificate authority, String file)
      throws IdentityException {
    boolean isSigned;
    try {
      Signature verifier = Signature.getInstance("SHA256withECDSA");
      verifier.initVerify(authority.getPublicKey());
      verifier.update(policy);
      String text = new String(signature, StandardCharsets.US_ASCII).strip();
      isSigned = verifier.verify(Base64.getDecoder().decode(text));
    } catch (GeneralSecurityException | IllegalArgumentException e) {
      throw new IdentityException(
          "the signature of " + file + " cannot be read (" + e + ")" + AGAIN, e);
    }
    if (!isSigned) {
      throw new IdentityException(
          file
              + " is not signed by the authority in "
              + SecurityFiles.AUTHORITY
              + ": it was changed, or is another team's"
              + AGAIN);
    }
  }
}
