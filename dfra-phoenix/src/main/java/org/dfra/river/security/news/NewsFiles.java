package org.dfra.river.security.news;

import java.io.IOException;
import java.math.BigInteger;
import java.nio.channels.FileChannel;
import java.nio.channels.FileLock;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.security.cert.X509Certificate;
import org.dfra.core.config.ConfigurationException;
import org.dfra.core.host.PrivateFiles;
import org.dfra.core.policy.Policy;
import org.dfra.core.policy.PolicyBundle;
import org.dfra.core.policy.PolicyReplacementException;
import org.dfra.core.policy.PolicySignatureException;
import org.dfra.core.policy.PolicyStore;
import org.dfra.core.policy.method.InterfaceCatalogue;
import org.dfra.river.identity.IdentityException;
import org.dfra.river.identity.SecurityFiles;
import org.dfra.river.identity.SignedFiles;
import org.dfra.river.security.news.TeamNews.SignedPolicy;

/**
 * What the authority has published, in the folder of the identity. All processes of a robot share
 * it: the one that stores something puts it in force at once, and the others notice it within half
 * a second. Thread-safe, also between processes.
 */
final class NewsFiles {

  private static final String LOCK = "revoked.lock";

  /** A lock of a file excludes other processes only. */
  private static final Object THIS_PROCESS = new Object();

  private final Path folder;
  private final X509Certificate authority;
  private final Runnable stored;

  /**
   * @param folder with the identity
   * @param authority must have signed everything
   * @param stored called after each change, without a lock
   */
  NewsFiles(Path folder, X509Certificate authority, Runnable stored) {
    this.folder = folder;
    this.authority = authority;
    this.stored = stored;
  }

  /** The stored list of revoked certificates. */
  byte[] revocations() throws IOException {
    return read(SecurityFiles.REVOKED);
  }

  /** The stored policy. */
  SignedPolicy policy() throws IOException {
    return new SignedPolicy(read(SecurityFiles.POLICY), read(SecurityFiles.POLICY_SIGNATURE));
  }

  private byte[] read(String name) throws IOException {
    try {
      return SecurityFiles.read(folder.resolve(name));
    } catch (IdentityException e) {
      throw new IOException(e.getMessage(), e);
    }
  }

  /**
   * Stores a list, if it is newer than the stored one.
   *
   * @throws IOException if it is not signed, or cannot be stored
   */
  void storeRevocations(byte[] list) throws IOException {
    if (list.length > SecurityFiles.maxBytes(SecurityFiles.REVOKED)) {
      throw new IOException("a list of revoked certificates has " + list.length + " bytes");
    }
    BigInteger number = number(list, "the list of revoked certificates that was offered");
    Path file = folder.resolve(SecurityFiles.REVOKED);
    Path lock = folder.resolve(LOCK);
    PrivateFiles.makeFile(lock);
    synchronized (THIS_PROCESS) {
      try (FileChannel channel = FileChannel.open(lock, StandardOpenOption.WRITE);
          FileLock unused = channel.lock()) {
        if (!Files.exists(file) || number(revocations(), file.toString()).compareTo(number) < 0) {
          PrivateFiles.write(file, list);
        }
      }
    }
    stored.run(); // also if another process has stored it meanwhile
  }

  private BigInteger number(byte[] list, String name) throws IOException {
    try {
      return SignedFiles.number(SignedFiles.revocations(list, authority, name))
          .orElse(BigInteger.ZERO);
    } catch (IdentityException e) {
      throw new IOException(e.getMessage(), e);
    }
  }

  /**
   * Stores a policy, if it is newer than the stored one.
   *
   * @throws IOException if it is not signed, has faults, or cannot be stored
   */
  void storePolicy(SignedPolicy policy) throws IOException {
    try {
      Policy unused =
          new PolicyStore(folder, authority, InterfaceCatalogue.builtIn())
              .store(PolicyBundle.of(policy.text(), policy.signature()));
    } catch (PolicySignatureException | ConfigurationException e) {
      throw new IOException(e.getMessage(), e);
    } catch (PolicyReplacementException e) {
      // it is not newer
    }
    stored.run();
  }
}
