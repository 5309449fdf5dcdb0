package org.dfra.cli.security;

import java.math.BigInteger;
import java.security.cert.X509CRL;
import java.security.cert.X509Certificate;
import java.time.Instant;
import java.util.List;
import java.util.Optional;
import org.dfra.core.policy.Policy;
import org.dfra.river.identity.CertificateFingerprint;
import org.dfra.river.identity.CertificateValidity;
import org.dfra.river.identity.Delegation;
import org.dfra.river.identity.SignedFiles;
import org.dfra.river.identity.StoredDelegations.Filed;
import org.dfra.river.identity.TeamCredentials;
import org.dfra.security.Member;
import org.jspecify.annotations.Nullable;

/**
 * A member as commands show it.
 *
 * @param name its name
 * @param role its role
 * @param team its team
 * @param subject of its certificate
 * @param validFrom first instant of its certificate
 * @param validUntil last instant of its certificate
 * @param state what the certificate is now
 * @param fingerprint SHA-256 of its certificate
 * @param authority subject of the authority's certificate
 * @param authorityFingerprint SHA-256 of the authority's certificate
 * @param revocationList number of the list of revoked certificates
 * @param policy version of the policy
 * @param delegations what operators have delegated to it, a sentence each
 */
record MemberView(
    String name,
    String role,
    String team,
    String subject,
    Instant validFrom,
    Instant validUntil,
    String state,
    String fingerprint,
    String authority,
    String authorityFingerprint,
    Optional<BigInteger> revocationList,
    Optional<Long> policy,
    List<String> delegations) {

  MemberView {
    delegations = List.copyOf(delegations);
  }

  /** What is in a bundle. */
  static MemberView of(VerifiedBundle bundle, Instant now) {
    return of(
        bundle.member(),
        bundle.certificate(),
        bundle.authority(),
        Optional.of(bundle.revocations()),
        bundle.policy(),
        List.of(),
        now);
  }

  /** What a computer has joined as. */
  static MemberView of(
      TeamCredentials credentials, Optional<Policy> policy, List<Filed> delegations, Instant now) {
    return of(
        credentials.member(),
        credentials.certificate(),
        credentials.authority(),
        credentials.revocations(),
        policy,
        delegations,
        now);
  }

  private static MemberView of(
      Member member,
      X509Certificate certificate,
      X509Certificate authority,
      Optional<X509CRL> revocations,
      Optional<Policy> policy,
      List<Filed> delegations,
      Instant now) {
    CertificateValidity validity = CertificateValidity.of(certificate, authority);
    boolean isRevoked = revocations.map(list -> list.isRevoked(certificate)).orElse(false);
    return new MemberView(
        member.name(),
        member.role().text(),
        member.team(),
        certificate.getSubjectX500Principal().getName(),
        validity.from(),
        validity.until(),
        isRevoked ? "revoked" : words(validity.at(now)),
        CertificateFingerprint.sha256(certificate),
        authority.getSubjectX500Principal().getName(),
        CertificateFingerprint.sha256(authority),
        revocations.flatMap(SignedFiles::number),
        policy.map(Policy::version),
        delegations.stream().map(each -> line(each, now)).toList());
  }

  private static String line(Filed filed, Instant now) {
    @Nullable Delegation delegation = filed.delegation();
    return delegation == null || !filed.fault().isEmpty()
        ? "Not used: " + filed.fault() + "; delete it."
        : DelegationView.of(delegation, now).line();
  }

  private static String words(CertificateValidity.Status status) {
    return switch (status) {
      case VALID -> "valid";
      case NOT_YET_VALID -> "not yet valid";
      case EXPIRED -> "expired";
    };
  }

  /** The member in a sentence, such as {@code robot atrv1 of field}. */
  String member() {
    return role + " " + name + " of " + team;
  }
}
