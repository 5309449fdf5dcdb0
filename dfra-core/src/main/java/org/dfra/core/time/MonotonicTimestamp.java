package org.dfra.core.time;

import java.io.IOException;
import java.time.Duration;
import org.dfra.time.Scheduler;

/**
 * A moment by monotonic time that is written down for another process: the next one may find out
 * how long ago it was, whatever has been done to the computer's clock.
 *
 * @param bootId names the boot that the time belongs to, see {@link BootId}; empty where it is not
 *     known, so that only this process understands the moment
 * @param nanos by {@link Scheduler#nanos}: on Linux the time since that boot
 */
public record MonotonicTimestamp(String bootId, long nanos) {

  /**
   * The moment that is now.
   *
   * @param id of this boot
   * @param time the monotonic time to go by
   */
  public static MonotonicTimestamp now(BootId id, Scheduler time) {
    return new MonotonicTimestamp(nameOf(id), time.nanos());
  }

  private static String nameOf(BootId id) {
    try {
      return id.read().orElse("");
    } catch (IOException e) { // as in a shortage of file descriptors; unknown is safe, see leastAge
      return "";
    }
  }

  /** Whether both are of the same boot, as far as that is known. */
  public boolean isSameBoot(MonotonicTimestamp other) {
    return !bootId.isEmpty() && bootId.equals(other.bootId);
  }

  /**
   * How long ago this was at least.
   *
   * @param now by the same monotonic time
   * @return the exact span within one boot; the time since the boot where this was in an earlier
   *     one; zero where a boot is not known
   */
  public Duration minAge(MonotonicTimestamp now) {
    if (bootId.isEmpty() || now.bootId.isEmpty()) {
      return Duration.ZERO;
    }
    long age = isSameBoot(now) ? now.nanos - nanos : now.nanos;
    return Duration.ofNanos(Math.max(0, age));
  }

  /** As {@link #parse} reads it. */
  @Override
  public String toString() {
    return nanos + " " + bootId;
  }

  /**
   * Reads what {@link #toString} wrote.
   *
   * @throws IllegalArgumentException if it is none
   */
  public static MonotonicTimestamp parse(String text) {
    int blank = text.indexOf(' ');
    if (blank < 0) {
      throw new IllegalArgumentException("\"" + text + "\" is no moment of a boot");
    }
    return new MonotonicTimestamp(
        text.substring(blank + 1), Long.parseLong(text.substring(0, blank)));
  }
}
