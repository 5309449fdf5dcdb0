package org.dfra.river.identity;

import java.security.cert.X509Certificate;
import java.time.Instant;

/**
 * When a member's certificate is valid: while it and that of the authority are.
 *
 * @param from its first instant
 * @param until its last instant
 */
public record CertificateValidity(Instant from, Instant until) {

  /** What a certificate is at an instant. */
  public enum Status {
    NOT_YET_VALID,
    VALID,
    EXPIRED
  }

  /** Of a certificate and its issuer's. */
  public static CertificateValidity of(X509Certificate certificate, X509Certificate issuer) {
    Instant from = certificate.getNotBefore().toInstant();
    Instant issuerFrom = issuer.getNotBefore().toInstant();
    Instant until = certificate.getNotAfter().toInstant();
    Instant issuerUntil = issuer.getNotAfter().toInstant();
    return new CertificateValidity(
        from.isAfter(issuerFrom) ? from : issuerFrom,
        until.isBefore(issuerUntil) ? until : issuerUntil);
  }

  /** What the certificate is at an instant. */
  public Status at(Instant now) {
    if (now.isBefore(from)) {
      return Status.NOT_YET_VALID;
    }
    return now.isAfter(until) ? Status.EXPIRED : Status.VALID;
  }
}
