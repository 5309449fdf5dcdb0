package org.dfra.river.security;

import java.io.IOException;
import java.nio.file.Path;
import java.security.cert.X509Certificate;
import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.FutureTask;
import org.dfra.core.policy.Policy;
import org.dfra.core.policy.PolicySignatureException;
import org.dfra.core.policy.PolicyStore;
import org.dfra.core.policy.method.InterfaceCatalogue;
import org.dfra.river.identity.IdentityException;
import org.dfra.river.identity.SecurityFiles;
import org.dfra.river.identity.TeamCertificates;

/**
 * The policy in the folder of an identity. It is read on a thread of its own while the process
 * opens its key stores, which takes as long; nothing is decided before both are there.
 */
final class StoredPolicy implements AutoCloseable {

  /** What was read, and by whose signature it was believed. */
  private record Read(X509Certificate authority, Optional<Policy> policy) {}

  private final Path folder;
  private final FutureTask<Read> reading = new FutureTask<>(this::read);
  private final Thread thread = new Thread(reading, "dfra-policy");

  private StoredPolicy(Path folder) {
    this.folder = folder;
  }

  /** Begins to read it. */
  static StoredPolicy begin(Path folder) {
    StoredPolicy policy = new StoredPolicy(folder);
    policy.thread.setDaemon(true);
    policy.thread.start();
    return policy;
  }

  private Read read() throws IOException, IdentityException {
    Path file = folder.resolve(SecurityFiles.AUTHORITY);
    X509Certificate authority =
        TeamCertificates.authority(SecurityFiles.read(file), file.toString());
    return new Read(authority, of(folder, authority));
  }

  /**
   * Waits for the policy.
   *
   * @param authority who must have signed it
   * @return empty if there is none
   * @throws IOException if it cannot be read, or the authority has not signed it
   * @throws org.dfra.core.config.ConfigurationException if it has faults
   */
  Optional<Policy> get(X509Certificate authority) throws IOException {
    try {
      Read read = reading.get();
      if (read.authority().equals(authority)) {
        return read.policy();
      }
    } catch (ExecutionException e) {
      if (!(e.getCause() instanceof IdentityException)) { // that of the key stores counts
        throw unwrapped(e);
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new IOException("the policy was not read: this thread was interrupted", e);
    }
    return of(folder, authority); // the folder was replaced meanwhile
  }

  private static IOException unwrapped(ExecutionException failure) {
    Throwable cause = failure.getCause();
    if (cause instanceof RuntimeException unchecked) {
      throw unchecked;
    }
    return cause instanceof IOException known ? known : new IOException(cause);
  }

  /** Waits until nothing reads it any more, also if the key stores could not be opened. */
  @Override
  public void close() {
    try {
      thread.join();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt(); // it ends by itself
    }
  }

  /**
   * Reads the policy now.
   *
   * @param authority who must have signed it
   * @return empty if there is none
   * @throws IOException if it cannot be read, or the authority has not signed it
   * @throws org.dfra.core.config.ConfigurationException if it has faults
   */
  static Optional<Policy> of(Path folder, X509Certificate authority) throws IOException {
    try {
      return new PolicyStore(folder, authority, InterfaceCatalogue.builtIn()).load();
    } catch (PolicySignatureException e) {
      throw new IOException(withFile(folder, e, ": "), e);
    } catch (IOException e) {
      throw new IOException(withFile(folder, e, " cannot be read: "), e);
    }
  }

  /** Operating systems leave out which file it is, and a check of bytes does not know it. */
  private static String withFile(Path folder, Exception failure, String between) {
    String message = Objects.toString(failure.getMessage(), failure.toString());
    return message.contains(folder.toString())
        ? message
        : folder.resolve(PolicyStore.POLICY) + between + message;
  }
}
