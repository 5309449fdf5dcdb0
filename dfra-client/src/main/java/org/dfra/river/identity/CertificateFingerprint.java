package org.dfra.river.identity;

import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.security.cert.CertificateEncodingException;
import java.security.cert.X509Certificate;
import java.util.HexFormat;

/** The SHA-256 fingerprint of a certificate, by which people compare two certificates. */
public final class CertificateFingerprint {

  private static final HexFormat PAIRS = HexFormat.ofDelimiter(":").withUpperCase();

  private CertificateFingerprint() {}

  /** As keytool and OpenSSL print it: 32 pairs of hexadecimal digits, separated by colons. */
  public static String sha256(X509Certificate certificate) {
    try {
      return PAIRS.formatHex(MessageDigest.getInstance("SHA-256").digest(certificate.getEncoded()));
    } catch (NoSuchAlgorithmException | CertificateEncodingException e) {
      throw new IllegalStateException("every JDK has SHA-256 and encodes what it has decoded", e);
    }
  }
}
