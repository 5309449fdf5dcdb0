package org.dfra.authority;

import java.io.IOException;
import java.math.BigInteger;
import java.nio.charset.StandardCharsets;
import java.security.GeneralSecurityException;
import java.security.cert.CertificateEncodingException;
import java.security.cert.X509Certificate;
import java.time.Instant;
import java.util.Base64;
import java.util.Date;
import java.util.List;
import org.bouncycastle.asn1.x509.CRLNumber;
import org.bouncycastle.asn1.x509.CRLReason;
import org.bouncycastle.asn1.x509.Extension;
import org.bouncycastle.cert.jcajce.JcaX509ExtensionUtils;
import org.bouncycastle.cert.jcajce.JcaX509v2CRLBuilder;
import org.bouncycastle.operator.OperatorCreationException;
import org.bouncycastle.operator.jcajce.JcaContentSignerBuilder;
import org.dfra.core.policy.PolicyBundle;
import org.dfra.river.identity.KeyEntry;

/** What the authority signs beside certificates: lists of revoked ones, and policies. */
final class AuthoritySignatures {

  private static final int PEM_COLUMNS = 64;

  private AuthoritySignatures() {}

  /**
   * A list of revoked certificates (X.509 CRL), in DER. It has no end before that of the authority:
   * a robot that is out of reach goes on with the list that it has.
   *
   * @param number higher than that of all lists before
   */
  static byte[] revocations(
      KeyEntry authority, BigInteger number, List<IssuedCertificate> revoked, Instant now) {
    X509Certificate certificate = authority.chain().get(0);
    JcaX509v2CRLBuilder builder =
        new JcaX509v2CRLBuilder(certificate.getSubjectX500Principal(), Date.from(now));
    builder.setNextUpdate(certificate.getNotAfter());
    for (IssuedCertificate each : revoked) {
      builder.addCRLEntry(
          each.serialNumber(),
          Date.from(each.revokedAt().orElseThrow()),
          CRLReason.unspecified); // RFC 5280, 5.3.1: then no reason is written
    }
    try {
      builder.addExtension(Extension.cRLNumber, false, new CRLNumber(number));
      builder.addExtension(
          Extension.authorityKeyIdentifier,
          false,
          new JcaX509ExtensionUtils().createAuthorityKeyIdentifier(certificate.getPublicKey()));
      return builder
          .build(new JcaContentSignerBuilder(CertificateSigner.SIGNATURE).build(authority.key()))
          .getEncoded();
    } catch (GeneralSecurityException | IOException | OperatorCreationException e) {
      throw new IllegalStateException("every JDK signs by ECDSA", e);
    }
  }

  /** The signature over a policy, in Base64, with the end of its line. */
  static byte[] policySignature(KeyEntry authority, byte[] policy) {
    try {
      return PolicyBundle.sign(policy, authority.key()).signature();
    } catch (GeneralSecurityException e) {
      throw new IllegalStateException("every JDK signs by ECDSA", e);
    }
  }

  /** A certificate in PEM (RFC 7468). */
  static byte[] pem(X509Certificate certificate) {
    try {
      String text =
          Base64.getMimeEncoder(PEM_COLUMNS, new byte[] {'\n'})
              .encodeToString(certificate.getEncoded());
      return ("-----BEGIN CERTIFICATE-----\n" + text + "\n-----END CERTIFICATE-----\n")
          .getBytes(StandardCharsets.US_ASCII);
    } catch (CertificateEncodingException e) {
      throw new IllegalStateException("every JDK encodes what it has decoded", e);
    }
  }
}
