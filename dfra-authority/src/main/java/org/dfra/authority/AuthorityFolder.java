package org.dfra.authority;

import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.channels.FileLock;
import java.nio.channels.OverlappingFileLockException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;
import java.security.cert.X509Certificate;
import java.time.Instant;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.stream.Stream;
import org.dfra.core.host.PrivateFiles;
import org.dfra.core.policy.BuiltInPolicies;
import org.dfra.river.identity.IdentityException;
import org.dfra.river.identity.KeyEntry;
import org.dfra.river.identity.SecurityFiles;
import org.dfra.river.identity.TeamCertificates;
import org.jspecify.annotations.Nullable;

/**
 * The private folder of an authority. Certificate, list of revoked certificates and policy have the
 * names of {@link SecurityFiles}.
 */
final class AuthorityFolder {

  /** The authority's key and certificate, in PKCS #12. */
  static final String KEY = "authority.p12";

  /** The passphrase of {@link #KEY}, where it is stored. */
  static final String PASSPHRASE = "authority.pass";

  /** The register of issued certificates. */
  static final String REGISTER = "issued.jsonl";

  private static final String ALIAS = "authority";
  private static final String LOCK = "lock";

  private final Path folder;

  AuthorityFolder(Path folder) {
    this.folder = folder;
  }

  Path file(String name) {
    return folder.resolve(name);
  }

  /**
   * Makes it with all its files: beside its place first, so that there is never half an authority.
   *
   * @param isStored whether the passphrase is stored beside the key
   * @throws AuthorityException if there is something at its place
   */
  void create(KeyEntry authority, String team, String passphrase, boolean isStored, Instant now)
      throws IOException {
    if (Files.exists(folder)) {
      throw new AuthorityException(
          folder + " exists already; name another folder with --authority");
    }
    Path parent =
        Objects.requireNonNull(folder.toAbsolutePath().getParent(), "a folder is in another");
    PrivateFiles.makeFolder(parent);
    Path draft = Files.createTempDirectory(parent, ".authority"); // mode 0700
    try {
      fill(draft, authority, team, passphrase, isStored, now);
      Path unused = Files.move(draft, folder, StandardCopyOption.ATOMIC_MOVE);
      PrivateFiles.sync(parent);
    } finally {
      delete(draft);
    }
  }

  private static void fill(
      Path draft, KeyEntry authority, String team, String passphrase, boolean isStored, Instant now)
      throws IOException {
    PrivateFiles.write(draft.resolve(KEY), authority.toKeyStore(ALIAS, passphrase.toCharArray()));
    if (isStored) {
      PrivateFiles.write(
          draft.resolve(PASSPHRASE), (passphrase + "\n").getBytes(StandardCharsets.UTF_8));
    }
    PrivateFiles.write(
        draft.resolve(SecurityFiles.AUTHORITY), AuthoritySignatures.pem(authority.chain().get(0)));
    PrivateFiles.write(draft.resolve(REGISTER), new byte[0]);
    new RevocationList(draft, authority).update(List.of(), now);
    PrivateFiles.write(
        draft.resolve(SecurityFiles.POLICY),
        BuiltInPolicies.standardText(team, 1).getBytes(StandardCharsets.UTF_8));
  }

  private static void delete(Path draft) throws IOException {
    if (Files.exists(draft)) {
      try (Stream<Path> files = Files.list(draft)) {
        for (Path each : files.toList()) {
          Files.delete(each);
        }
      }
      Files.delete(draft);
    }
  }

  /**
   * Refuses a folder that is missing, has no authority, or that other users may enter.
   *
   * @throws AuthorityException with the remedy
   */
  void require() throws IOException {
    if (!Files.exists(file(KEY))) {
      throw new AuthorityException(
          "there is no authority in "
              + folder
              + "; make one with \"security init TEAM\", or name its folder with --authority");
    }
    PrivateFiles.requireFolder(folder);
    PrivateFiles.requireFile(file(KEY));
  }

  /**
   * Prevents that two commands change it at the same time.
   *
   * @throws AuthorityException if another command does
   */
  FileChannel lock() throws IOException {
    PrivateFiles.makeFile(file(LOCK));
    FileChannel channel = FileChannel.open(file(LOCK), StandardOpenOption.WRITE);
    @Nullable FileLock lock = null;
    try {
      lock = channel.tryLock();
    } catch (OverlappingFileLockException e) {
      lock = null; // this process holds it
    } finally {
      if (lock == null) {
        channel.close();
      }
    }
    if (lock == null) {
      throw new AuthorityException(
          "another command uses the authority in "
              + folder
              + " now; repeat this when it has ended");
    }
    return channel;
  }

  /** The stored passphrase; empty if it is not stored. */
  Optional<String> storedPassphrase() throws IOException {
    Path stored = file(PASSPHRASE);
    if (!Files.exists(stored)) {
      return Optional.empty();
    }
    PrivateFiles.requireFile(stored);
    return Files.readString(stored).lines().findFirst();
  }

  /**
   * Opens the key.
   *
   * @throws AuthorityException if the passphrase is wrong, or the file is no key store
   */
  KeyEntry key(String passphrase) throws IOException {
    try {
      return KeyEntry.read(
          Files.readAllBytes(file(KEY)), passphrase.toCharArray(), ALIAS, file(KEY).toString());
    } catch (IdentityException e) {
      throw new AuthorityException(String.valueOf(e.getMessage()), e);
    }
  }

  /** The authority's certificate. */
  X509Certificate certificate() throws IOException {
    Path file = file(SecurityFiles.AUTHORITY);
    try {
      return TeamCertificates.authority(Files.readAllBytes(file), file.toString());
    } catch (IdentityException e) {
      throw new AuthorityException(file + " is not the authority's certificate; restore it", e);
    }
  }

  /** The policy; empty if the team has none. */
  Optional<byte[]> policy() throws IOException {
    Path file = file(SecurityFiles.POLICY);
    return Files.exists(file) ? Optional.of(Files.readAllBytes(file)) : Optional.empty();
  }
}
