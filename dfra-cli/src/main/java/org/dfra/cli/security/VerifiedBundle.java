package org.dfra.cli.security;

import java.security.cert.X509CRL;
import java.security.cert.X509Certificate;
import java.time.Instant;
import java.util.Optional;
import org.dfra.core.policy.Policy;
import org.dfra.river.identity.CertificateValidity;
import org.dfra.river.identity.IdentityException;
import org.dfra.river.identity.KeyChecks;
import org.dfra.river.identity.KeyEntry;
import org.dfra.river.identity.SecurityFiles;
import org.dfra.river.identity.SignedFiles;
import org.dfra.river.identity.TeamCertificates;
import org.dfra.security.Member;
import org.dfra.security.MemberRole;

/**
 * A bundle that was opened and checked: everything in it comes from one authority.
 *
 * @param bundle it
 * @param member whom its certificate names
 * @param identity the member's key and certificates
 * @param authority the authority's certificate
 * @param revocations the list of revoked certificates
 * @param policy the team's policy; empty if it has none
 * @param robotKey the key between a robot's processes; empty if the member is no robot
 */
public record VerifiedBundle(
    Bundle bundle,
    Member member,
    KeyEntry identity,
    X509Certificate authority,
    X509CRL revocations,
    Optional<Policy> policy,
    Optional<KeyEntry> robotKey) {

  /** The member's certificate. */
  public X509Certificate certificate() {
    return identity.chain().get(0);
  }

  /** When the member's certificate is valid. */
  public CertificateValidity validity() {
    return CertificateValidity.of(certificate(), authority);
  }

  /**
   * Opens a bundle and checks it, whatever the clock says.
   *
   * @param passphrase the one-time passphrase, as it was typed
   * @param file the bundle's name, for messages
   * @throws IdentityException if the passphrase is wrong or anything in it is not what it should be
   * @throws org.dfra.core.config.ConfigurationException if its policy cannot be read here
   */
  public static VerifiedBundle open(Bundle bundle, String passphrase, String file)
      throws IdentityException {
    X509Certificate authority =
        TeamCertificates.authority(
            bundle.required(SecurityFiles.AUTHORITY), in(file, SecurityFiles.AUTHORITY));
    char[] opens = OneTimePassphrase.normalized(passphrase).toCharArray();
    String identityFile = in(file, SecurityFiles.IDENTITY);
    KeyEntry identity =
        KeyEntry.read(
            bundle.required(SecurityFiles.IDENTITY),
            opens,
            SecurityFiles.IDENTITY_ALIAS,
            identityFile);
    Member member = TeamCertificates.member(identity.chain(), authority, identityFile);
    KeyChecks.requireMatch(identity.key(), identity.chain().get(0), identityFile);
    X509CRL revocations =
        SignedFiles.revocations(
            bundle.required(SecurityFiles.REVOKED), authority, in(file, SecurityFiles.REVOKED));
    Optional<Policy> policy =
        BundledPolicy.of(bundle, authority, member.team(), in(file, SecurityFiles.POLICY));
    Optional<KeyEntry> robotKey = robotKey(bundle, member, opens, file);
    return new VerifiedBundle(bundle, member, identity, authority, revocations, policy, robotKey);
  }

  /**
   * Checks that the member may be what it says now.
   *
   * @param now what this computer's clock says
   * @throws IdentityException if its certificate is expired, not yet valid or revoked
   */
  public void requireUsable(String file, Instant now) throws IdentityException {
    Optional<String> fault = TeamCertificates.validityFault(member, validity(), file, now);
    if (fault.isPresent()) {
      throw new IdentityException(fault.get());
    }
    if (revocations.isRevoked(certificate())) {
      throw new IdentityException(
          "the authority has revoked the certificate of " + member + " in " + file);
    }
  }

  private static Optional<KeyEntry> robotKey(
      Bundle bundle, Member member, char[] passphrase, String file) throws IdentityException {
    Optional<byte[]> bytes = bundle.file(SecurityFiles.ROBOT);
    boolean isRobot = member.role() == MemberRole.ROBOT;
    if (bytes.isPresent() != isRobot) {
      throw new IdentityException(
          file
              + (isRobot ? " has no " : " is of no robot, but has ")
              + SecurityFiles.ROBOT
              + "; ask for a new bundle");
    }
    if (bytes.isEmpty()) {
      return Optional.empty();
    }
    String robotFile = in(file, SecurityFiles.ROBOT);
    KeyEntry entry = KeyEntry.read(bytes.get(), passphrase, SecurityFiles.ROBOT_ALIAS, robotFile);
    KeyChecks.requireRobotKey(entry.asRobotKey(), member, robotFile);
    return Optional.of(entry);
  }

  private static String in(String file, String name) {
    return file + " (" + name + ")";
  }
}
