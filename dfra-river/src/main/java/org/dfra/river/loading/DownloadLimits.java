package org.dfra.river.loading;

import java.time.Duration;

/**
 * The limits of a download.
 *
 * @param jarBytes size of a jar
 * @param unpackedBytes size of all its contents, unpacked
 * @param entries number of files in it
 * @param timeout time limit of the whole download
 */
public record DownloadLimits(long jarBytes, long unpackedBytes, int entries, Duration timeout) {

  /** 16 MiB packed, 64 MiB unpacked, 10 000 entries, 5 s. */
  public static final DownloadLimits DEFAULT =
      new DownloadLimits(16 << 20, 64 << 20, 10_000, Duration.ofSeconds(5));

  public DownloadLimits {
    if (jarBytes < 1 || unpackedBytes < 1 || entries < 1 || timeout.toMillis() < 1) {
      throw new IllegalArgumentException(
          "a limit below 1: "
              + jarBytes
              + " bytes, "
              + unpackedBytes
              + " unpacked, "
              + entries
              + " entries, "
              + timeout);
    }
  }
}
