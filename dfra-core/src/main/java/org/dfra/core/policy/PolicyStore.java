package org.dfra.core.policy;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.channels.FileLock;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;
import java.security.cert.X509Certificate;
import java.util.Arrays;
import java.util.Optional;
import org.dfra.core.config.ConfigurationException;
import org.dfra.core.host.PrivateFiles;
import org.dfra.core.policy.method.InterfaceCatalogue;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * A folder with the signed policy of a robot: {@value #POLICY} and {@value #SIGNATURE}. It is
 * replaced atomically, also for other processes and after a crash, and only by a higher version.
 *
 * <p>Both files are written beside the old ones first. The signature is renamed before the policy:
 * if a crash lies between, the new policy beside the old one fits the new signature, and the next
 * use completes the change.
 */
public final class PolicyStore {

  /** Name of the policy's file. */
  public static final String POLICY = "policy.xml";

  /** Name of the signature's file. */
  public static final String SIGNATURE = "policy.sig";

  /** Suffix of a file that replaces another one. */
  static final String NEW = ".new";

  /** Name of the note that a policy is valid by its schema. */
  static final String VALID = "policy.valid";

  private static final Logger LOG = LoggerFactory.getLogger(PolicyStore.class);

  private static final String LOCK = "policy.lock";

  /** A lock of a file excludes other processes only. */
  private static final Object THIS_PROCESS = new Object();

  private final Path folder;
  private final X509Certificate authority;
  private final InterfaceCatalogue catalogue;

  /**
   * @param folder private, see {@link PrivateFiles}; created if missing
   * @param authority certificate of the team's authority
   * @param catalogue the interfaces that policies may name
   */
  public PolicyStore(Path folder, X509Certificate authority, InterfaceCatalogue catalogue) {
    this.folder = folder;
    this.authority = authority;
    this.catalogue = catalogue;
  }

  /**
   * The stored policy.
   *
   * @return empty if there is none
   * @throws PolicySignatureException if the authority has not signed it
   * @throws ConfigurationException if it has faults
   * @throws IOException if it cannot be read
   */
  public Optional<Policy> load() throws IOException, PolicySignatureException {
    if (!Files.exists(folder)) {
      return Optional.empty();
    }
    synchronized (THIS_PROCESS) {
      try (FileChannel file = lockFile();
          FileLock unused = file.lock()) {
        Optional<byte[]> stored = verified();
        return stored.map(this::readStored);
      }
    }
  }

  /**
   * Stores a policy, unless it is the stored one.
   *
   * @return the policy
   * @throws PolicySignatureException if the authority has not signed it, or not the stored one
   * @throws PolicyReplacementException if it is not newer than the stored one
   * @throws ConfigurationException if it has faults
   * @throws IOException if it cannot be written; then the old one stays
   */
  public Policy store(PolicyBundle bundle) throws IOException, PolicySignatureException {
    bundle.verify(authority);
    Policy next = PolicyXml.read(bundle.policy(), path(), catalogue);
    PrivateFiles.requireFolderOrParent(folder);
    synchronized (THIS_PROCESS) {
      try (FileChannel file = lockFile();
          FileLock unused = file.lock()) {
        Optional<byte[]> stored = verified();
        if (stored.isEmpty()
            || PolicyXml.identity(stored.get(), path()).isReplacedBy(next.identity(), path())) {
          write(POLICY + NEW, bundle.policy());
          write(SIGNATURE + NEW, bundle.signature());
          rename(SIGNATURE);
          rename(POLICY);
        }
      }
    }
    return next;
  }

  /**
   * Validates a stored policy by its schema only once: each process of a robot reads it before it
   * can work. Its signature is checked each time. The folder is private, so nobody else can have
   * written the note.
   */
  private Policy readStored(byte[] text) {
    String checksum = PolicyXml.checksum(text);
    Path note = folder.resolve(VALID);
    boolean isValid = isNoted(note, checksum);
    Policy policy = PolicyXml.read(text, path(), catalogue, isValid);
    if (!isValid) {
      try {
        PrivateFiles.write(note, checksum.getBytes(StandardCharsets.US_ASCII));
      } catch (IOException e) {
        LOG.debug("{} cannot be written, so the next process validates again.", note, e);
      }
    }
    return policy;
  }

  private static boolean isNoted(Path note, String checksum) {
    try (InputStream in = Files.newInputStream(note)) {
      byte[] read = in.readNBytes(checksum.length() + 1);
      return Arrays.equals(read, checksum.getBytes(StandardCharsets.US_ASCII));
    } catch (IOException e) { // missing, mostly: validating is always right
      return false;
    }
  }

  private String path() {
    return folder.resolve(POLICY).toString();
  }

  private FileChannel lockFile() throws IOException {
    Path lock = folder.resolve(LOCK);
    PrivateFiles.makeFile(lock);
    return FileChannel.open(lock, StandardOpenOption.WRITE);
  }

  /** The text of the stored policy; completes a change that a crash has interrupted. */
  @GuardedBy("THIS_PROCESS")
  private Optional<byte[]> verified() throws IOException, PolicySignatureException {
    Optional<byte[]> signature = read(SIGNATURE);
    Optional<byte[]> policy = read(POLICY);
    Optional<byte[]> next = read(POLICY + NEW);
    if (signature.isEmpty() && policy.isEmpty()) {
      return Optional.empty();
    }
    if (signature.isPresent() && next.isPresent() && isSigned(next.get(), signature.get())) {
      rename(POLICY);
      policy = next;
    }
    if (signature.isEmpty() || policy.isEmpty()) {
      throw new PolicySignatureException(
          folder
              + " has "
              + (policy.isEmpty()
                  ? SIGNATURE + " without " + POLICY
                  : POLICY + " without " + SIGNATURE)
              + "; copy both from the authority");
    }
    PolicyBundle.of(policy.get(), signature.get()).verify(authority);
    return policy;
  }

  private boolean isSigned(byte[] policy, byte[] signature) {
    try {
      PolicyBundle.of(policy, signature).verify(authority);
      return true;
    } catch (PolicySignatureException e) { // it is not what the signature belongs to
      return false;
    }
  }

  /** At most one byte more than the largest policy, which is refused then. */
  private Optional<byte[]> read(String name) throws IOException {
    try (InputStream in = Files.newInputStream(folder.resolve(name))) {
      return Optional.of(in.readNBytes(PolicyXml.MAX_BYTES + 1));
    } catch (NoSuchFileException e) {
      return Optional.empty();
    }
  }

  private void write(String name, byte[] content) throws IOException {
    Path file = folder.resolve(name);
    PrivateFiles.makeFile(file);
    try (FileChannel channel =
        FileChannel.open(file, StandardOpenOption.TRUNCATE_EXISTING, StandardOpenOption.WRITE)) {
      ByteBuffer left = ByteBuffer.wrap(content);
      while (left.hasRemaining()) {
        int unused = channel.write(left);
      }
      channel.force(true);
    }
  }

  private void rename(String name) throws IOException {
    Path unused =
        Files.move(
            folder.resolve(name + NEW),
            folder.resolve(name),
            StandardCopyOption.ATOMIC_MOVE,
            StandardCopyOption.REPLACE_EXISTING);
    try (FileChannel directory = FileChannel.open(folder, StandardOpenOption.READ)) {
      directory.force(true); // syncs the new name itself
    }
  }
}
