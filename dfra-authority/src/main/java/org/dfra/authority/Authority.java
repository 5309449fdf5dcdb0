package org.dfra.authority;

import java.io.IOException;
import java.math.BigInteger;
import java.nio.channels.FileChannel;
import java.nio.file.Path;
import java.security.SecureRandom;
import java.security.cert.X509Certificate;
import java.time.Clock;
import java.time.Duration;
import java.time.Instant;
import java.time.temporal.ChronoUnit;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.function.Predicate;
import java.util.function.Supplier;
import javax.naming.InvalidNameException;
import javax.naming.ldap.LdapName;
import javax.naming.ldap.Rdn;
import javax.security.auth.x500.X500Principal;
import org.dfra.cli.security.Bundle;
import org.dfra.cli.security.BundledPolicy;
import org.dfra.cli.security.OneTimePassphrase;
import org.dfra.core.host.PrivateFiles;
import org.dfra.core.policy.PolicyBundle;
import org.dfra.river.identity.KeyEntry;
import org.dfra.river.identity.SecurityFiles;
import org.dfra.security.Member;
import org.dfra.security.MemberRole;

/**
 * The authority of a team. One command at a time may have it open. Not thread-safe.
 *
 * <p>The register of issued certificates is written first: what it lacks does not exist, and the
 * list of revoked certificates follows it when the authority is opened again after a failure.
 */
public final class Authority implements AutoCloseable {

  private final AuthorityFolder folder;
  private final Clock clock;
  private final FileChannel lock;
  private final KeyEntry key;
  private final CertificateRegister register;
  private final RevocationList revocations;
  private final CertificateSigner signer = new CertificateSigner();
  private final SecureRandom random = new SecureRandom();

  /**
   * A member's bundle.
   *
   * @param passphrase that opens it; it is kept nowhere
   * @param certificate as the register has it
   */
  public record IssuedBundle(Bundle bundle, String passphrase, IssuedCertificate certificate) {}

  /**
   * A key that signs code.
   *
   * @param keyStore in PKCS #12, its entry named {@code code}
   * @param passphrase that opens it; it is kept nowhere
   * @param certificate as the register has it
   */
  public record IssuedCodeKey(byte[] keyStore, String passphrase, IssuedCertificate certificate) {}

  private Authority(AuthorityFolder folder, Clock clock, FileChannel lock, KeyEntry key, Path at) {
    this.folder = folder;
    this.clock = clock;
    this.lock = lock;
    this.key = key;
    register = new CertificateRegister(folder.file(AuthorityFolder.REGISTER));
    revocations = new RevocationList(at, key);
  }

  /**
   * Makes the authority of a new team, with the policy that comes with DFRA.
   *
   * @param folder where; it must not exist
   * @param team name of the team, as {@link Member#NAME_RULE} has it
   * @param passphrase of its key
   * @param isStored store the passphrase beside the key
   * @throws IOException if the folder exists or cannot be written
   * @throws IllegalArgumentException if the team's name is none
   */
  public static void create(
      Path folder, String team, String passphrase, boolean isStored, Clock clock)
      throws IOException {
    Instant now = clock.instant();
    String checked = new Member(team, MemberRole.OPERATOR, "authority").team();
    new AuthorityFolder(folder)
        .create(
            new CertificateSigner().authority(checked, now), checked, passphrase, isStored, now);
  }

  /**
   * Opens an authority.
   *
   * @param passphrase asked for if it is not stored beside the key
   * @throws IOException if there is no authority, another command uses it, or the passphrase is
   *     wrong
   */
  public static Authority open(Path folder, Supplier<String> passphrase, Clock clock)
      throws IOException {
    AuthorityFolder files = new AuthorityFolder(folder);
    files.require();
    FileChannel lock = files.lock();
    try {
      Optional<String> stored = files.storedPassphrase();
      KeyEntry key = files.key(stored.isPresent() ? stored.get() : passphrase.get());
      Authority opened = new Authority(files, clock, lock, key, folder);
      opened.revocations.update(opened.register.all(), opened.now());
      return opened;
    } catch (IOException | RuntimeException e) {
      lock.close();
      throw e;
    }
  }

  /** What an authority has issued, in the order of time. Needs no passphrase. */
  public static List<IssuedCertificate> issued(Path folder) throws IOException {
    AuthorityFolder files = new AuthorityFolder(folder);
    files.require();
    return new CertificateRegister(files.file(AuthorityFolder.REGISTER)).all();
  }

  /** Its certificate. */
  public X509Certificate certificate() {
    return key.chain().get(0);
  }

  /** The name of its team. */
  public String team() {
    try {
      for (Rdn each : new LdapName(certificate().getSubjectX500Principal().getName()).getRdns()) {
        if (each.getType().equalsIgnoreCase("O")) {
          return String.valueOf(each.getValue());
        }
      }
    } catch (InvalidNameException e) {
      throw new IllegalStateException("a certificate has a valid name", e);
    }
    throw new IllegalStateException("the authority's certificate names no team");
  }

  /** All that it has issued. */
  public List<IssuedCertificate> issued() throws IOException {
    return register.all();
  }

  /**
   * Issues a member a new certificate, whether it has one or not.
   *
   * @throws org.dfra.core.config.ConfigurationException if the policy in the folder has faults
   */
  public IssuedBundle issue(MemberRole role, String name, Duration validity) throws IOException {
    Member member = new Member(team(), role, name);
    KeyEntry issued = signer.member(key, member.x500(), now(), validity);
    String passphrase = OneTimePassphrase.create(random);
    Map<String, byte[]> files = new TreeMap<>();
    char[] opens = passphrase.toCharArray();
    files.put(SecurityFiles.IDENTITY, issued.toKeyStore(SecurityFiles.IDENTITY_ALIAS, opens));
    if (role == MemberRole.ROBOT) {
      files.put(
          SecurityFiles.ROBOT, signer.robotKey(name).toKeyStore(SecurityFiles.ROBOT_ALIAS, opens));
    }
    files.put(SecurityFiles.AUTHORITY, AuthoritySignatures.pem(certificate()));
    files.put(SecurityFiles.REVOKED, revocations.bytes());
    addPolicy(files);
    IssuedCertificate entry = entry(role.text(), name, issued);
    register.add(entry);
    return new IssuedBundle(Bundle.of(files), passphrase, entry);
  }

  private void addPolicy(Map<String, byte[]> files) throws IOException {
    Optional<PolicyBundle> policy = policy();
    if (policy.isPresent()) {
      files.put(SecurityFiles.POLICY, policy.get().policy());
      files.put(SecurityFiles.POLICY_SIGNATURE, policy.get().signature());
    }
  }

  /**
   * Signs the policy that is in the folder.
   *
   * @return empty if there is none
   * @throws org.dfra.core.config.ConfigurationException if it has faults, or is of another team
   */
  public Optional<PolicyBundle> policy() throws IOException {
    Optional<byte[]> policy = folder.policy();
    if (policy.isEmpty()) {
      return Optional.empty();
    }
    Path file = folder.file(SecurityFiles.POLICY);
    var unused = BundledPolicy.read(policy.get(), team(), file.toString());
    byte[] signature = AuthoritySignatures.policySignature(key, policy.get());
    PrivateFiles.write(folder.file(SecurityFiles.POLICY_SIGNATURE), signature);
    return Optional.of(PolicyBundle.of(policy.get(), signature));
  }

  /** Issues a key that signs code, and does nothing else. */
  public IssuedCodeKey issueCode(String name, Duration validity) throws IOException {
    String checked = new Member(team(), MemberRole.OPERATOR, name).name();
    X500Principal subject =
        new X500Principal("CN=" + checked + ",OU=" + IssuedCertificate.CODE + ",O=" + team());
    KeyEntry issued = signer.code(key, subject, now(), validity);
    String passphrase = OneTimePassphrase.create(random);
    IssuedCertificate entry = entry(IssuedCertificate.CODE, checked, issued);
    register.add(entry);
    return new IssuedCodeKey(
        issued.toKeyStore(IssuedCertificate.CODE, passphrase.toCharArray()), passphrase, entry);
  }

  private IssuedCertificate entry(String role, String name, KeyEntry issued) {
    X509Certificate certificate = issued.chain().get(0);
    return new IssuedCertificate(
        certificate.getSerialNumber().toString(16),
        role,
        name,
        team(),
        certificate.getNotBefore().toInstant().toString(),
        certificate.getNotAfter().toInstant().toString(),
        null,
        null);
  }

  /**
   * Revokes certificates, also expired ones, and writes the next list.
   *
   * @param reason in a few words, for the register
   * @return those that were not revoked before
   */
  public List<IssuedCertificate> revoke(Predicate<IssuedCertificate> which, String reason)
      throws IOException {
    List<IssuedCertificate> revoked = register.revoke(which, now(), reason);
    revocations.update(register.all(), now());
    return revoked;
  }

  /** The present list of revoked certificates, in DER. */
  public byte[] revocations() throws IOException {
    return revocations.bytes();
  }

  /** The number of the present list. */
  public BigInteger revocationNumber() throws IOException {
    return revocations.number();
  }

  /** In whole seconds, as certificates have them. */
  private Instant now() {
    return clock.instant().truncatedTo(ChronoUnit.SECONDS);
  }

  /** Lets other commands use it. */
  @Override
  public void close() throws IOException {
    lock.close();
  }
}
