package org.dfra.river.identity;

import java.nio.file.Path;
import java.security.PrivateKey;
import java.security.cert.X509CRL;
import java.security.cert.X509Certificate;
import java.time.Instant;
import java.util.List;
import java.util.Optional;
import javax.security.auth.Subject;
import org.dfra.security.Member;

/**
 * What the processes of this computer prove to others that they are: a member of a team, by its key
 * and certificate. Immutable and thread-safe.
 *
 * <p>Certificates were checked against the authority's when this was loaded, but neither against
 * the clock nor against the list of revoked ones: the caller decides what an {@linkplain
 * #validity() expired} or {@linkplain #isRevoked() revoked} member may still do.
 */
public final class TeamCredentials {

  private final Path folder;
  private final Subject subject;
  private final Member member;
  private final PrivateKey privateKey;
  private final List<X509Certificate> chain;
  private final Optional<X509CRL> revocations;
  private final Optional<RobotKey> robotKey;

  /**
   * A robot's key for calls between its own processes. It has no dates and no issuer, so it works
   * whatever the clock says.
   *
   * @param certificate it, self-signed
   */
  public record RobotKey(PrivateKey key, X509Certificate certificate) {

    /** Without the key. */
    @Override
    public String toString() {
      return certificate.getSubjectX500Principal().getName();
    }
  }

  /**
   * @param folder where they were loaded from, for messages
   * @param subject read-only
   * @param chain the member's certificate and its authority's
   */
  TeamCredentials(
      Path folder,
      Subject subject,
      Member member,
      PrivateKey privateKey,
      List<X509Certificate> chain,
      Optional<X509CRL> revocations,
      Optional<RobotKey> robotKey) {
    this.folder = folder;
    this.subject = subject;
    this.member = member;
    this.privateKey = privateKey;
    this.chain = List.copyOf(chain);
    this.revocations = revocations;
    this.robotKey = robotKey;
  }

  /**
   * What JAAS logged in: read-only. Its principals are the {@link #member()}, the name in the
   * certificate, and those that the user's own login modules have added.
   */
  public Subject subject() {
    return subject;
  }

  /** Whom the certificate names. */
  public Member member() {
    return member;
  }

  /** The member's key. */
  public PrivateKey privateKey() {
    return privateKey;
  }

  /** The member's certificate, then the authority's. */
  public X509Certificate[] chain() {
    return chain.toArray(X509Certificate[]::new);
  }

  /** The member's certificate. */
  public X509Certificate certificate() {
    return chain.get(0);
  }

  /** The certificate of the team's authority. */
  public X509Certificate authority() {
    return chain.get(chain.size() - 1);
  }

  /** The list of revoked certificates, signed by the authority; empty if the folder has none. */
  public Optional<X509CRL> revocations() {
    return revocations;
  }

  /** Whether the authority has revoked the member's certificate, as far as the list says. */
  public boolean isRevoked() {
    return revocations.map(list -> list.isRevoked(certificate())).orElse(false);
  }

  /** The robot's key; empty if the member is no robot or has none. */
  public Optional<RobotKey> robotKey() {
    return robotKey;
  }

  /** When the certificate is valid. */
  public CertificateValidity validity() {
    return CertificateValidity.of(certificate(), authority());
  }

  /**
   * Why the certificate is not valid at an instant, in a sentence with the remedy.
   *
   * @param now what this computer's clock says
   * @return empty if it is valid
   */
  public Optional<String> validityFault(Instant now) {
    String file = folder.resolve(SecurityFiles.IDENTITY).toString();
    return TeamCertificates.validityFault(member, validity(), file, now);
  }

  /** Names the member and no key. */
  @Override
  public String toString() {
    return member + " (" + folder + ")";
  }
}
