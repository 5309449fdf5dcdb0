package org.dfra.river.identity;

import java.lang.System.Logger.Level;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.security.cert.CertPath;
import java.security.cert.X509CRL;
import java.security.cert.X509Certificate;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import javax.security.auth.Subject;
import javax.security.auth.x500.X500PrivateCredential;
import org.dfra.river.identity.TeamCredentials.RobotKey;
import org.dfra.security.Member;

/**
 * The folder with the identity of this computer's processes, which {@code security join} writes.
 * {@link SecurityFiles} has the names of its files.
 */
public final class IdentityFolder {

  private static final System.Logger LOG = System.getLogger(IdentityFolder.class.getName());

  private IdentityFolder() {}

  /**
   * Whether this computer has joined a team, be it that its identity can be used or not. Only a
   * computer that has not may be open to everybody.
   *
   * @param securityFolder {@code security} in the state folder
   */
  public static boolean isJoined(Path securityFolder) {
    return Files.exists(securityFolder, LinkOption.NOFOLLOW_LINKS)
        || Files.exists(replaced(securityFolder), LinkOption.NOFOLLOW_LINKS);
  }

  /**
   * Where the former folder lies while a new one takes its place. If the computer fails meanwhile,
   * this is all that is left, and it is loaded.
   */
  public static Path replaced(Path securityFolder) {
    return securityFolder.resolveSibling(securityFolder.getFileName() + ".old");
  }

  /**
   * Logs in by JAAS and checks what the folder has. A certificate that is expired, not yet valid or
   * revoked is loaded all the same: see {@link TeamCredentials#validity} and {@link
   * TeamCredentials#isRevoked}. May ask for a passphrase on the terminal.
   *
   * @param securityFolder {@code security} in the state folder
   * @throws IdentityException if a file is missing, unreadable, open to other users or not what it
   *     should be, or the login fails
   */
  public static TeamCredentials load(Path securityFolder) throws IdentityException {
    Path folder = present(securityFolder);
    Path authorityFile = folder.resolve(SecurityFiles.AUTHORITY);
    X509Certificate authority =
        TeamCertificates.authority(SecurityFiles.read(authorityFile), authorityFile.toString());
    IdentityLogin login = new IdentityLogin(folder);
    Subject subject = login.login();
    String identity = folder.resolve(SecurityFiles.IDENTITY).toString();
    X500PrivateCredential credential = credential(subject, folder);
    X509Certificate certificate = credential.getCertificate();
    Member member = TeamCertificates.member(chain(subject, certificate), authority, identity);
    KeyChecks.requireMatch(credential.getPrivateKey(), certificate, identity);
    Optional<X509CRL> revocations = revocations(folder, authority);
    Optional<RobotKey> robotKey = robotKey(folder, login);
    if (robotKey.isPresent()) {
      KeyChecks.requireRobotKey(
          robotKey.get(), member, folder.resolve(SecurityFiles.ROBOT).toString());
    }
    subject.getPrincipals().add(member);
    subject.setReadOnly();
    return new TeamCredentials(
        folder,
        subject,
        member,
        credential.getPrivateKey(),
        List.of(certificate, authority),
        revocations,
        robotKey);
  }

  /**
   * What a robot can work with for itself when {@link #load} has failed.
   *
   * @param securityFolder {@code security} in the state folder
   * @throws IdentityException if the robot's own key cannot be used either, or this is no robot
   */
  public static RobotAlone loadAlone(Path securityFolder) throws IdentityException {
    Path folder = present(securityFolder);
    Path file = folder.resolve(SecurityFiles.ROBOT);
    RobotKey key =
        robotKey(folder, new IdentityLogin(folder))
            .orElseThrow(
                () ->
                    new IdentityException(
                        file + " is missing: only robots have a key of their own"));
    X509Certificate authority = key.certificate();
    Path authorityFile = folder.resolve(SecurityFiles.AUTHORITY);
    try {
      authority =
          TeamCertificates.authority(SecurityFiles.read(authorityFile), authorityFile.toString());
    } catch (IdentityException e) {
      LOG.log(Level.WARNING, "Only the robot's own key is known: " + e.getMessage());
    }
    return new RobotAlone(KeyChecks.robot(key, authority, file.toString()), key, authority);
  }

  /** The folder, or the former one while another takes its place. */
  private static Path present(Path folder) throws IdentityException {
    Path former = replaced(folder);
    Path present = Files.isDirectory(folder) || !Files.isDirectory(former) ? folder : former;
    if (!Files.isDirectory(present)) {
      throw new IdentityException(
          present
              + (isJoined(folder) ? " is no folder" : " does not exist")
              + ", so this computer has no identity of a team; type: security join NAME.bundle");
    }
    SecurityFiles.requirePrivate(present);
    return present;
  }

  /** The one key with a certificate that the login modules have found. */
  private static X500PrivateCredential credential(Subject subject, Path folder)
      throws IdentityException {
    Set<X500PrivateCredential> all = subject.getPrivateCredentials(X500PrivateCredential.class);
    if (all.size() != 1) {
      throw new IdentityException(
          "the login that "
              + folder.resolve(SecurityFiles.JAAS)
              + " describes gave "
              + all.size()
              + " keys with certificates instead of one; correct its entry, or delete the file");
    }
    return all.iterator().next();
  }

  /** The certificate with those that the login modules have found with it. */
  private static List<X509Certificate> chain(Subject subject, X509Certificate certificate) {
    return subject.getPublicCredentials(CertPath.class).stream()
        .map(path -> path.getCertificates().stream().map(X509Certificate.class::cast).toList())
        .filter(path -> !path.isEmpty() && path.get(0).equals(certificate))
        .findFirst()
        .orElse(List.of(certificate));
  }

  private static Optional<X509CRL> revocations(Path folder, X509Certificate authority)
      throws IdentityException {
    Path file = folder.resolve(SecurityFiles.REVOKED);
    Optional<byte[]> bytes = SecurityFiles.readIfThere(file);
    return bytes.isEmpty()
        ? Optional.empty()
        : Optional.of(SignedFiles.revocations(bytes.get(), authority, file.toString()));
  }

  private static Optional<RobotKey> robotKey(Path folder, IdentityLogin login)
      throws IdentityException {
    Path file = folder.resolve(SecurityFiles.ROBOT);
    Optional<byte[]> bytes = SecurityFiles.readIfThere(file);
    if (bytes.isEmpty()) {
      return Optional.empty();
    }
    SecurityFiles.requirePrivate(file);
    Path passphraseFile = folder.resolve(SecurityFiles.ROBOT_PASSPHRASE);
    Optional<char[]> passphrase = login.passphrase(SecurityFiles.ROBOT_PASSPHRASE);
    if (passphrase.isEmpty()) {
      throw new IdentityException(
          passphraseFile + " is missing; join the team again: security join NAME.bundle");
    }
    RobotKey robotKey =
        KeyEntry.read(bytes.get(), passphrase.get(), SecurityFiles.ROBOT_ALIAS, file.toString())
            .asRobotKey();
    return Optional.of(robotKey);
  }
}
