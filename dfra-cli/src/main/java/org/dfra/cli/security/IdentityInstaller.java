package org.dfra.cli.security;

import java.io.IOException;
import java.math.BigInteger;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.SecureRandom;
import java.security.cert.CRLException;
import java.security.cert.X509CRL;
import java.time.Instant;
import java.util.Optional;
import org.dfra.core.config.ConfigurationException;
import org.dfra.core.host.PrivateFiles;
import org.dfra.core.policy.Policy;
import org.dfra.core.policy.PolicySignatureException;
import org.dfra.core.policy.PolicyStore;
import org.dfra.river.identity.IdentityException;
import org.dfra.river.identity.IdentityFolder;
import org.dfra.river.identity.KeyEntry;
import org.dfra.river.identity.SecurityFiles;
import org.dfra.river.identity.SignedFiles;
import org.dfra.river.identity.TeamCredentials;

/**
 * Writes the folder of an identity, {@code security} in the state folder. It is written beside and
 * takes its place by a rename, so that it is never half of one: a failure before leaves what was.
 */
public final class IdentityInstaller {

  private static final long NO_POLICY = -1;

  private final Path state;
  private final SecureRandom random = new SecureRandom();

  /**
   * @param state the state folder; made if it is missing
   */
  public IdentityInstaller(Path state) {
    this.state = state;
  }

  /** The folder of the identity. */
  public Path folder() {
    return state.resolve(SecurityFiles.FOLDER);
  }

  /**
   * Joins a team.
   *
   * <p>A computer that joins as the same member again keeps its robot's key, so that processes that
   * run already still know those that start later; a list of revoked certificates that is newer
   * than the bundle's, and a policy that is; and its {@code jaas.conf}. The latest time that the
   * computer knows of is always kept.
   *
   * @param file the bundle's name, for messages
   * @param now what this computer's clock says
   * @param isForced replace the identity of another member, or one that cannot be read
   * @throws IdentityException if the bundle's certificate cannot be used now, or this computer is
   *     another member and {@code isForced} is not said
   * @throws IOException if the folder cannot be written
   */
  public void install(VerifiedBundle bundle, String file, Instant now, boolean isForced)
      throws IdentityException, IOException {
    bundle.requireUsable(file, now);
    PrivateFiles.requireFolder(state);
    FolderReplacement replacement = new FolderReplacement(folder());
    replacement.undoInterrupted();
    Optional<TeamCredentials> former = former(bundle, isForced);
    Path draft = Files.createTempDirectory(state, "." + SecurityFiles.FOLDER); // mode 0700
    try {
      write(draft, bundle, former);
      PrivateFiles.sync(draft);
      replacement.replaceWith(draft);
    } finally {
      FolderReplacement.delete(draft);
    }
  }

  /** The same member's identity that is there already. */
  private Optional<TeamCredentials> former(VerifiedBundle bundle, boolean isForced)
      throws IdentityException {
    if (!IdentityFolder.isJoined(folder())) {
      return Optional.empty();
    }
    TeamCredentials former;
    try {
      former = IdentityFolder.load(folder());
    } catch (IdentityException e) {
      if (isForced) {
        return Optional.empty();
      }
      throw new IdentityException(
          "the identity that this computer has cannot be read, so nothing is replaced ("
              + e.getMessage()
              + "); to replace it, add --force",
          e);
    }
    boolean isSame =
        former.member().equals(bundle.member()) && former.authority().equals(bundle.authority());
    if (!isSame && !isForced) {
      boolean isOtherAuthority = former.member().equals(bundle.member());
      throw new IdentityException(
          "this computer is "
              + former.member()
              + (isOtherAuthority ? " already, by another authority" : "")
              + ", and the bundle is of "
              + bundle.member()
              + "; to replace the identity, add --force");
    }
    return isSame ? Optional.of(former) : Optional.empty();
  }

  private void write(Path draft, VerifiedBundle bundle, Optional<TeamCredentials> former)
      throws IOException {
    writeKey(
        draft,
        bundle.identity(),
        SecurityFiles.IDENTITY,
        SecurityFiles.IDENTITY_PASSPHRASE,
        SecurityFiles.IDENTITY_ALIAS);
    Optional<KeyEntry> robotKey =
        former.flatMap(TeamCredentials::robotKey).map(KeyEntry::of).or(bundle::robotKey);
    if (robotKey.isPresent()) {
      writeKey(
          draft,
          robotKey.get(),
          SecurityFiles.ROBOT,
          SecurityFiles.ROBOT_PASSPHRASE,
          SecurityFiles.ROBOT_ALIAS);
    }
    write(draft, SecurityFiles.AUTHORITY, bundle.bundle().required(SecurityFiles.AUTHORITY));
    write(draft, SecurityFiles.REVOKED, newest(bundle, former));
    writePolicy(draft, bundle, former);
    Path latest = folder().resolve(SecurityFiles.LATEST_TIME);
    if (Files.exists(latest)) { // time goes on, also for another member
      write(draft, SecurityFiles.LATEST_TIME, Files.readAllBytes(latest));
    }
    Path jaas = folder().resolve(SecurityFiles.JAAS);
    if (former.isPresent() && Files.exists(jaas)) {
      write(draft, SecurityFiles.JAAS, Files.readAllBytes(jaas));
    }
  }

  /** The newer of the bundle's and the one that is there, which may have come another way. */
  private void writePolicy(Path draft, VerifiedBundle bundle, Optional<TeamCredentials> former)
      throws IOException {
    boolean isFormerNewer = former.isPresent() && formerVersion(bundle) > version(bundle.policy());
    for (String each : new String[] {SecurityFiles.POLICY, SecurityFiles.POLICY_SIGNATURE}) {
      Optional<byte[]> content =
          isFormerNewer
              ? Optional.of(Files.readAllBytes(folder().resolve(each)))
              : bundle.bundle().file(each);
      if (content.isPresent()) {
        write(draft, each, content.get());
      }
    }
  }

  private long formerVersion(VerifiedBundle bundle) throws IOException {
    try {
      return version(
          new PolicyStore(folder(), bundle.authority(), BundledPolicy.catalogue()).load());
    } catch (PolicySignatureException | ConfigurationException e) {
      return NO_POLICY; // damaged: to join again repairs it
    }
  }

  private static long version(Optional<Policy> policy) {
    return policy.map(Policy::version).orElse(NO_POLICY);
  }

  private void writeKey(Path draft, KeyEntry entry, String store, String passphrase, String alias)
      throws IOException {
    String opens = OneTimePassphrase.create(random);
    write(draft, store, entry.toKeyStoreOfRandom(alias, opens.toCharArray()));
    write(draft, passphrase, (opens + "\n").getBytes(StandardCharsets.US_ASCII));
  }

  private static void write(Path draft, String name, byte[] content) throws IOException {
    PrivateFiles.write(draft.resolve(name), content);
  }

  private static byte[] newest(VerifiedBundle bundle, Optional<TeamCredentials> former) {
    X509CRL own = bundle.revocations();
    X509CRL newest =
        former
            .flatMap(TeamCredentials::revocations)
            .filter(there -> number(there).compareTo(number(own)) > 0)
            .orElse(own);
    try {
      return newest.getEncoded();
    } catch (CRLException e) {
      throw new IllegalStateException("every JDK encodes what it has decoded", e);
    }
  }

  private static BigInteger number(X509CRL list) {
    return SignedFiles.number(list).orElse(BigInteger.ZERO);
  }
}
