package org.dfra.cli.security;

import java.math.BigInteger;
import java.security.cert.CertificateException;
import java.security.cert.X509Certificate;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.dfra.river.identity.CertificateFingerprint;
import org.dfra.river.identity.IdentityException;

/**
 * A certificate as commands show it: an authority's, or any other.
 *
 * @param subject whose it is
 * @param issuer who has signed it
 * @param validFrom its first instant
 * @param validUntil its last instant
 * @param purposes what it is for
 * @param fingerprint its SHA-256
 * @param revocationList number of the list of revoked certificates beside it
 * @param policy version of the policy beside it
 */
record CertificateView(
    String subject,
    String issuer,
    Instant validFrom,
    Instant validUntil,
    List<String> purposes,
    String fingerprint,
    Optional<BigInteger> revocationList,
    Optional<Long> policy) {

  private static final Map<String, String> PURPOSES =
      Map.of(
          "1.3.6.1.5.5.7.3.1", "server of connections",
          "1.3.6.1.5.5.7.3.2", "client of connections",
          "1.3.6.1.5.5.7.3.3", "signer of code");

  /** Of a certificate alone. */
  static CertificateView of(X509Certificate certificate, String file) throws IdentityException {
    return of(certificate, file, Optional.empty(), Optional.empty());
  }

  static CertificateView of(
      X509Certificate certificate,
      String file,
      Optional<BigInteger> revocationList,
      Optional<Long> policy)
      throws IdentityException {
    return new CertificateView(
        certificate.getSubjectX500Principal().getName(),
        certificate.getIssuerX500Principal().getName(),
        certificate.getNotBefore().toInstant(),
        certificate.getNotAfter().toInstant(),
        purposes(certificate, file),
        CertificateFingerprint.sha256(certificate),
        revocationList,
        policy);
  }

  private static List<String> purposes(X509Certificate certificate, String file)
      throws IdentityException {
    List<String> purposes = new ArrayList<>();
    if (certificate.getBasicConstraints() >= 0) {
      purposes.add("authority");
    }
    try {
      for (String each : Optional.ofNullable(certificate.getExtendedKeyUsage()).orElse(List.of())) {
        purposes.add(PURPOSES.getOrDefault(each, each));
      }
    } catch (CertificateException e) {
      throw new IdentityException(
          "the certificate in " + file + " has purposes that cannot be read (" + e + ")", e);
    }
    return purposes;
  }
}
