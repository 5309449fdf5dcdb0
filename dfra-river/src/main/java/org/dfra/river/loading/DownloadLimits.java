package org.dfra.river.loading;

import java.time.Duration;

/**
 * How much a download may cost.
 *
 * @param jarBytes size of a jar
 * @param unpackedBytes size of all that is in it, unpacked
 * @param entries how many files it may hold
 * @param timeout how long its download may take in all
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
