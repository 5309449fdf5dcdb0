package org.dfra.river.loading;

import java.time.Duration;

/**
 * How much a download may cost.
 *
 * @param jarBytes size of a jar
 * @param unpackedBytes size of all that is in it, unpacked
 * @param entries how many files it may hold
 * @param patience how long its download may take in all
 */
public record CodeLimits(long jarBytes, long unpackedBytes, int entries, Duration patience) {

  /** 16 MiB packed, 64 MiB unpacked, 10 000 entries, 5 s. */
  public static final CodeLimits DEFAULT =
      new CodeLimits(16 << 20, 64 << 20, 10_000, Duration.ofSeconds(5));

  public CodeLimits {
    if (jarBytes < 1 || unpackedBytes < 1 || entries < 1 || patience.toMillis() < 1) {
      throw new IllegalArgumentException(
          "a limit below 1: "
              + jarBytes
              + " bytes, "
              + unpackedBytes
              + " unpacked, "
              + entries
              + " entries, "
              + patience);
    }
  }
}
