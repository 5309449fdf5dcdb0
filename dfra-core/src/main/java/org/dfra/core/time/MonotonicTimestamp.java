package org.dfra.core.time;

import java.io.IOException;
import java.time.Duration;
import org.dfra.time.Scheduler;

/**
 * A time stamp by the monotonic clock that is stored for another process: a later process can
 * compute its age, even if the computer's clock was set.
 *
 * @param bootId the boot that the time belongs to, see {@link BootId}; empty if unknown, so that
 *     only this process can use the time stamp
 * @param nanos the time of {@link Scheduler#nanos}: on Linux the time since that boot
 */
public record MonotonicTimestamp(String bootId, long nanos) {

  /**
   * The current time.
   *
   * @param id the ID of this boot
   * @param time the monotonic clock
   */
  public static MonotonicTimestamp now(BootId id, Scheduler time) {
    return new MonotonicTimestamp(nameOf(id), time.nanos());
  }

  private static String nameOf(BootId id) {
    try {
      return id.read().orElse("");
    } catch (IOException e) { // as in a shortage of file descriptors; unknown is safe, see minAge
      return "";
    }
  }

  /** Whether both are of the same boot, as far as known. */
  public boolean isSameBoot(MonotonicTimestamp other) {
    return !bootId.isEmpty() && bootId.equals(other.bootId);
  }

  /**
   * The minimum age of this time stamp.
   *
   * @param now the current time by the same monotonic clock
   * @return the exact age within one boot; the time since boot if this belongs to an earlier boot;
   *     zero if a boot is unknown
   */
  public Duration minAge(MonotonicTimestamp now) {
    if (bootId.isEmpty() || now.bootId.isEmpty()) {
      return Duration.ZERO;
    }
    long age = isSameBoot(now) ? now.nanos - nanos : now.nanos;
    return Duration.ofNanos(Math.max(0, age));
  }

  /** The format of {@link #parse}. */
  @Override
  public String toString() {
    return nanos + " " + bootId;
  }

  /**
   * Parses the format of {@link #toString}.
   *
   * @throws IllegalArgumentException if it is not one
   */
  public static MonotonicTimestamp parse(String text) {
    int blank = text.indexOf(' ');
    if (blank < 0) {
      throw new IllegalArgumentException("\"" + text + "\" is not a time since a boot");
    }
    return new MonotonicTimestamp(
        text.substring(blank + 1), Long.parseLong(text.substring(0, blank)));
  }
}
