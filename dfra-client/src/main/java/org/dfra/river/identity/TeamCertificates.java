package org.dfra.river.identity;

import java.io.ByteArrayInputStream;
import java.security.GeneralSecurityException;
import java.security.cert.CertPathValidator;
import java.security.cert.CertPathValidatorException;
import java.security.cert.Certificate;
import java.security.cert.CertificateException;
import java.security.cert.CertificateFactory;
import java.security.cert.PKIXParameters;
import java.security.cert.TrustAnchor;
import java.security.cert.X509Certificate;
import java.time.Instant;
import java.util.Collection;
import java.util.Date;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.dfra.security.Member;

/**
 * Checks of a team's certificates. All of them leave the clock aside, so that an expired member is
 * still known by name; {@link #validityFault} is the check of the dates.
 */
public final class TeamCertificates {

  private static final String AGAIN = "; join the team again: security join NAME.bundle";
  private static final String SERVER = "1.3.6.1.5.5.7.3.1"; // RFC 5280, 4.2.1.12
  private static final String CLIENT = "1.3.6.1.5.5.7.3.2";
  private static final String CODE = "1.3.6.1.5.5.7.3.3";
  private static final int DIGITAL_SIGNATURE = 0; // bits of RFC 5280, 4.2.1.3
  private static final int KEY_CERT_SIGN = 5;
  private static final int CRL_SIGN = 6;

  private TeamCertificates() {}

  /**
   * Reads the certificate of the team's authority.
   *
   * @param bytes the file, in PEM or DER
   * @param file its name, for messages
   * @throws IdentityException if it has not exactly one certificate, or not one of an authority
   */
  public static X509Certificate authority(byte[] bytes, String file) throws IdentityException {
    Collection<? extends Certificate> all;
    try {
      all =
          CertificateFactory.getInstance("X.509")
              .generateCertificates(new ByteArrayInputStream(bytes));
    } catch (CertificateException e) {
      throw new IdentityException(file + " is no certificate in PEM (" + e + ")" + AGAIN, e);
    }
    if (all.size() > 1) {
      throw new IdentityException(
          file
              + " has the certificates of "
              + all.size()
              + " authorities, but a team has one"
              + AGAIN);
    }
    if (all.isEmpty() || !(all.iterator().next() instanceof X509Certificate authority)) {
      throw new IdentityException(file + " has no certificate" + AGAIN);
    }
    boolean[] usage = authority.getKeyUsage();
    if (authority.getBasicConstraints() < 0
        || usage == null
        || !usage[KEY_CERT_SIGN]
        || !usage[CRL_SIGN]) {
      throw new IdentityException(
          file
              + " is the certificate of "
              + authority.getSubjectX500Principal()
              + ", which may not sign certificates and lists, so it is no authority"
              + AGAIN);
    }
    return authority;
  }

  /**
   * Checks a member's certificate, whatever the clock says: that the authority has signed it, that
   * it may authenticate both ends of a connection, and that it names a member.
   *
   * @param chain the member's certificate, and maybe the authority's
   * @param file where it is from, for messages
   * @throws IdentityException if a check fails
   */
  public static Member member(List<X509Certificate> chain, X509Certificate authority, String file)
      throws IdentityException {
    X509Certificate certificate = chain.get(0);
    requireIssuedBy(authority, chain, file);
    requireUsage(certificate, file);
    try {
      return Member.of(certificate.getSubjectX500Principal());
    } catch (IllegalArgumentException e) {
      throw new IdentityException("the certificate in " + file + ": " + e.getMessage() + AGAIN, e);
    }
  }

  /**
   * Whether the authority lets a key sign code, whatever the clock says: its certificate is for
   * code alone. Certificates of members are not.
   *
   * @param chain the certificate of the key, and maybe the authority's
   */
  public static boolean isForCode(List<X509Certificate> chain, X509Certificate authority) {
    X509Certificate certificate = chain.get(0);
    try {
      requireIssuedBy(authority, chain, "a signature");
      boolean[] usage = certificate.getKeyUsage();
      return usage != null
          && usage[DIGITAL_SIGNATURE]
          && certificate.getBasicConstraints() < 0
          && List.of(CODE).equals(certificate.getExtendedKeyUsage());
    } catch (IdentityException | CertificateException e) { // of somebody else, or not readable
      return false;
    }
  }

  private static void requireIssuedBy(
      X509Certificate authority, List<X509Certificate> chain, String file)
      throws IdentityException {
    X509Certificate certificate = chain.get(0);
    if (chain.size() > 2 || chain.size() == 2 && !chain.get(1).equals(authority)) {
      throw new IdentityException(
          "the certificate in "
              + file
              + " comes with that of another authority, "
              + chain.get(chain.size() - 1).getSubjectX500Principal()
              + ", than "
              + SecurityFiles.AUTHORITY
              + AGAIN);
    }
    CertificateValidity validity = CertificateValidity.of(certificate, authority);
    try {
      PKIXParameters parameters = new PKIXParameters(Set.of(new TrustAnchor(authority, null)));
      parameters.setRevocationEnabled(false);
      parameters.setDate(Date.from(validity.from()));
      var unused =
          CertPathValidator.getInstance("PKIX")
              .validate(
                  CertificateFactory.getInstance("X.509").generateCertPath(List.of(certificate)),
                  parameters);
    } catch (CertPathValidatorException e) {
      throw new IdentityException(
          "the certificate in "
              + file
              + ", of "
              + certificate.getSubjectX500Principal()
              + ", is not from the authority in "
              + SecurityFiles.AUTHORITY
              + " ("
              + e.getMessage()
              + ")"
              + AGAIN,
          e);
    } catch (GeneralSecurityException e) {
      throw new IdentityException(
          "the certificate in " + file + " cannot be checked (" + e + ")" + AGAIN, e);
    }
  }

  private static void requireUsage(X509Certificate certificate, String file)
      throws IdentityException {
    boolean[] usage = certificate.getKeyUsage();
    List<String> extended;
    try {
      extended = Optional.ofNullable(certificate.getExtendedKeyUsage()).orElse(List.of());
    } catch (CertificateException e) {
      throw new IdentityException(
          "the key usage of the certificate in " + file + " cannot be read (" + e + ")" + AGAIN, e);
    }
    boolean isForConnections =
        usage != null
            && usage[DIGITAL_SIGNATURE]
            && extended.contains(SERVER)
            && extended.contains(CLIENT);
    if (!isForConnections || certificate.getBasicConstraints() >= 0) {
      throw new IdentityException(
          "the certificate in "
              + file
              + " is not for connections of a member: it needs digitalSignature, serverAuth and"
              + " clientAuth, and may sign no other"
              + AGAIN);
    }
  }

  /**
   * Why a certificate is not valid at an instant, in a sentence with the remedy.
   *
   * @param file where it is, for messages
   * @param now what this computer's clock says
   * @return empty if it is valid
   */
  public static Optional<String> validityFault(
      Member member, CertificateValidity validity, String file, Instant now) {
    String whose = "the certificate of " + member + " in " + file;
    return switch (validity.at(now)) {
      case VALID -> Optional.empty();
      case NOT_YET_VALID ->
          Optional.of(
              whose
                  + " is valid from "
                  + validity.from()
                  + " on, but this computer's clock says "
                  + now
                  + "; set the clock");
      case EXPIRED ->
          Optional.of(
              whose
                  + " expired at "
                  + validity.until()
                  + " by this computer's clock, which says "
                  + now
                  + "; type \"security renew "
                  + member.name()
                  + "\" on the authority's computer and join the new bundle");
    };
  }
}
