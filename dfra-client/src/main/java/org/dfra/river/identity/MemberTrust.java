package org.dfra.river.identity;

import java.net.Socket;
import java.security.GeneralSecurityException;
import java.security.PublicKey;
import java.security.cert.CertPathValidator;
import java.security.cert.CertificateException;
import java.security.cert.CertificateFactory;
import java.security.cert.PKIXParameters;
import java.security.cert.TrustAnchor;
import java.security.cert.X509Certificate;
import java.time.Instant;
import java.time.InstantSource;
import java.util.Date;
import java.util.List;
import java.util.Set;
import javax.net.ssl.SSLEngine;
import javax.net.ssl.X509ExtendedTrustManager;
import org.dfra.security.Caller.Standing;
import org.dfra.security.Member;
import org.dfra.text.PrintableText;
import org.jspecify.annotations.Nullable;

/**
 * Decides which certificates are believed: those that the team's authority has issued and not
 * revoked, and the own ones. An expired one is believed to have been a member's; what that still
 * permits is decided for each call.
 *
 * <p>Own certificates have no dates: a robot whose certificate has expired keeps working for
 * itself.
 */
final class MemberTrust extends X509ExtendedTrustManager {

  private static final String SERVERS = "1.3.6.1.5.5.7.3.1"; // RFC 5280 section 4.2.1.12
  private static final String CLIENTS = "1.3.6.1.5.5.7.3.2";

  private final X509Certificate authority;
  private final String team;
  private final Set<PublicKey> own;
  private final RevokedCertificates revoked;
  private final InstantSource clock;

  /**
   * @param authority of the team
   * @param team name of the team
   * @param own the public keys of this robot or person
   * @param revoked certificates
   */
  MemberTrust(
      X509Certificate authority,
      String team,
      Set<PublicKey> own,
      RevokedCertificates revoked,
      InstantSource clock) {
    this.authority = authority;
    this.team = team;
    this.own = Set.copyOf(own);
    this.revoked = revoked;
    this.clock = clock;
  }

  /** What a certificate proves now. Its chain was checked before. */
  Standing standing(X509Certificate certificate) {
    if (own.contains(certificate.getPublicKey())) {
      return Standing.OWN;
    } else if (revoked.contains(certificate)) {
      return Standing.STRANGER;
    }
    Instant now = clock.instant();
    if (now.isBefore(certificate.getNotBefore().toInstant())) {
      return Standing.STRANGER;
    }
    return now.isAfter(certificate.getNotAfter().toInstant()) ? Standing.EXPIRED : Standing.MEMBER;
  }

  /** Whether it was revoked. Own ones are, too. */
  boolean isRevoked(X509Certificate certificate) {
    return revoked.contains(certificate);
  }

  /** Checks a certificate that is not of this connection: its issuer, its dates and its use. */
  void checkClient(X509Certificate certificate) throws CertificateException {
    check(new X509Certificate[] {certificate}, CLIENTS);
  }

  private void check(X509Certificate @Nullable [] chain, String usage) throws CertificateException {
    if (chain == null || chain.length == 0) {
      throw new CertificateException("there is no certificate");
    }
    X509Certificate leaf = chain[0];
    if (own.contains(leaf.getPublicKey())) {
      return;
    }
    String name = PrintableText.name(leaf.getSubjectX500Principal().getName()); // not believed yet
    Instant from = leaf.getNotBefore().toInstant();
    Instant now = clock.instant();
    boolean isEarly = now.isBefore(from);
    if (isEarly && !mayLearn()) {
      throw notBefore(name, from, now);
    }
    Instant until = leaf.getNotAfter().toInstant();
    Instant checked = now.isAfter(until) ? until : now;
    checkPath(chain, name, isEarly ? from : checked);
    checkUsage(leaf, name, usage);
    if (revoked.contains(leaf)) {
      throw new CertificateException("the certificate of " + name + " is revoked");
    }
    checkMember(leaf);
    if (isEarly && !(clock instanceof FlooredClock known && known.learn(from))) {
      throw notBefore(name, from, now);
    }
  }

  /** Without a clock, a certificate's begin says how late it is at least. */
  private boolean mayLearn() {
    return clock instanceof FlooredClock known && !known.isSet();
  }

  private static CertificateException notBefore(String name, Instant from, Instant now) {
    return new CertificateException(
        "the certificate of " + name + " is not valid before " + from + "; it is " + now);
  }

  /** An expired certificate is checked as of its last second. */
  private void checkPath(X509Certificate[] chain, String name, Instant at)
      throws CertificateException {
    int length = chain.length;
    if (length > 1 && chain[length - 1].equals(authority)) {
      length--;
    }
    try {
      PKIXParameters parameters = new PKIXParameters(Set.of(new TrustAnchor(authority, null)));
      parameters.setRevocationEnabled(false); // by RevokedCertificates
      parameters.setDate(Date.from(at));
      Object unused =
          CertPathValidator.getInstance("PKIX")
              .validate(
                  CertificateFactory.getInstance("X.509")
                      .generateCertPath(List.of(chain).subList(0, length)),
                  parameters);
    } catch (GeneralSecurityException e) {
      throw new CertificateException(
          "the certificate of "
              + name
              + " is not of "
              + authority.getSubjectX500Principal().getName()
              + ": "
              + e.getMessage(),
          e);
    }
  }

  private static void checkUsage(X509Certificate leaf, String name, String usage)
      throws CertificateException {
    @Nullable List<String> usages = leaf.getExtendedKeyUsage();
    if (usages == null || !usages.contains(usage)) {
      throw new CertificateException(
          "the certificate of "
              + name
              + " is not for "
              + (usage.equals(SERVERS) ? "servers" : "clients")
              + " of encrypted calls");
    }
  }

  private void checkMember(X509Certificate leaf) throws CertificateException {
    try {
      Member member = Member.of(leaf.getSubjectX500Principal());
      if (!member.team().equals(team)) {
        throw new CertificateException(member + " is of another team than " + team);
      }
    } catch (IllegalArgumentException e) {
      throw new CertificateException(e.getMessage(), e);
    }
  }

  @Override
  public void checkClientTrusted(X509Certificate[] chain, String type) throws CertificateException {
    check(chain, CLIENTS);
  }

  @Override
  public void checkServerTrusted(X509Certificate[] chain, String type) throws CertificateException {
    check(chain, SERVERS);
  }

  @Override
  public void checkClientTrusted(X509Certificate[] chain, String type, Socket socket)
      throws CertificateException {
    check(chain, CLIENTS);
  }

  @Override
  public void checkServerTrusted(X509Certificate[] chain, String type, Socket socket)
      throws CertificateException {
    check(chain, SERVERS);
  }

  @Override
  public void checkClientTrusted(X509Certificate[] chain, String type, SSLEngine engine)
      throws CertificateException {
    check(chain, CLIENTS);
  }

  @Override
  public void checkServerTrusted(X509Certificate[] chain, String type, SSLEngine engine)
      throws CertificateException {
    check(chain, SERVERS);
  }

  @Override
  public X509Certificate[] getAcceptedIssuers() {
    return new X509Certificate[] {authority};
  }
}
