package org.dfra.river.loading;

import java.io.IOException;
import java.nio.file.Path;
import java.security.cert.X509Certificate;
import java.time.Duration;
import java.util.Set;

/**
 * The code that this virtual machine may load.
 *
 * @param signers certificates of the keys that may sign jars; each stands for its own key only, not
 *     for keys that it has certified
 * @param pinned SHA-256 digests of jars that are loaded regardless of their signatures
 * @param limits limits of a download
 */
record CodeTrust(
    Set<X509Certificate> signers, Set<String> pinned, CodeTrust.DownloadLimits limits) {

  /** System property with the path of the trust file. If it is not set, no code is trusted. */
  public static final String PROPERTY = "dfra.trust";

  /** Trusts nothing: no code is loaded from elsewhere. */
  public static final CodeTrust NONE = new CodeTrust(Set.of(), Set.of(), DownloadLimits.DEFAULT);

  public CodeTrust {
    signers = Set.copyOf(signers);
    pinned = Set.copyOf(pinned);
    for (String digest : pinned) {
      if (!Digests.isSha256(digest)) {
        throw new IllegalArgumentException(
            "the pinned digest \"" + digest + "\" is not a SHA-256: write 64 digits 0-9 and a-f");
      }
    }
  }

  /**
   * Reads a trust file; its keys are in docs/reference/trusted-code.md.
   *
   * @throws IOException naming the file and the key if it cannot be read or is invalid
   */
  public static CodeTrust read(Path file) throws IOException {
    return new TrustFile(file).read();
  }

  /**
   * The trust from the file in system property {@value #PROPERTY}, or {@link #NONE}.
   *
   * @throws IOException as {@link #read} does
   */
  public static CodeTrust configured() throws IOException {
    String file = System.getProperty(PROPERTY);
    return file == null || file.isBlank() ? NONE : read(Path.of(file));
  }

  /**
   * The limits of a download.
   *
   * @param jarBytes size of a jar
   * @param unpackedBytes size of all its contents, unpacked
   * @param entries number of files in it
   * @param timeout time limit of the whole download
   */
  record DownloadLimits(long jarBytes, long unpackedBytes, int entries, Duration timeout) {

    /** 16 MiB packed, 64 MiB unpacked, 10 000 entries, 5 s. */
    public static final DownloadLimits DEFAULT =
        new DownloadLimits(16 << 20, 64 << 20, 10_000, Duration.ofSeconds(5));

    public DownloadLimits {
      if (jarBytes < 1 || unpackedBytes < 1 || entries < 1 || timeout.toMillis() < 1) {
        throw new IllegalArgumentException(
            "each limit of a download must be at least 1: "
                + jarBytes
                + " bytes, "
                + unpackedBytes
                + " bytes unpacked, "
                + entries
                + " entries, "
                + timeout.toMillis()
                + " ms");
      }
    }
  }
}
