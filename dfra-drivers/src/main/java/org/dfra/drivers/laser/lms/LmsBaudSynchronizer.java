package org.dfra.drivers.laser.lms;

import java.io.IOException;
import java.time.Duration;
import java.util.Optional;
import org.dfra.drivers.link.SerialLink;
import org.jspecify.annotations.Nullable;

/**
 * Keeps this end of the line at the laser's speed, and tells when it is better not to say anything.
 *
 * <pre>
 *   IDLE --laser will change its speed--&gt; SWITCHED --followed--&gt; SETTLING --250 ms--&gt; IDLE
 *    |                                                                                ^
 *    '--laser resets itself--&gt; WAKING, at the slowest speed --it woke, or 60 s--------'
 * </pre>
 *
 * <p>Confined to the reader thread.
 */
final class LmsBaudSynchronizer {

  private static final Duration SETTLING_TIME = Duration.ofMillis(250);

  /** How long a laser may take to wake. */
  static final Duration WAKING = Duration.ofSeconds(60);

  private final LmsBaudSearch speeds;
  private boolean switched; // the far end has changed its speed, this one follows
  private boolean waking;
  private long wakingUntilNanos;
  private long quietUntilNanos;

  LmsBaudSynchronizer(Optional<LmsBaud> target) {
    this.speeds = new LmsBaudSearch(target);
  }

  LmsBaudSearch speeds() {
    return speeds;
  }

  /** Sets this end to the next speed to be tried; see {@link LmsBaudSearch#next}. */
  @Nullable String search(SerialLink link, long now) {
    switched = false;
    waking = false;
    quietUntilNanos = now;
    return speeds.next(link);
  }

  /** The laser has said that it will change its speed. */
  void switched() {
    switched = true;
  }

  /** The laser has said that it will reset itself. */
  void resets(long now) {
    waking = true;
    wakingUntilNanos = now + WAKING.toNanos();
  }

  /** The laser has said that it is awake. */
  void poweredOn() {
    waking = false;
    speeds.restart();
  }

  boolean isPoweringOn() {
    return waking;
  }

  /**
   * Does what is due.
   *
   * @return false if the laser has not woken in time, and must be searched
   */
  boolean update(SerialLink link, long now) throws IOException {
    if (switched) {
      switched = false;
      speeds.followWanted(link);
      quietUntilNanos = now + SETTLING_TIME.toNanos();
    }
    if (waking && !speeds.isAtSlowest()) {
      speeds.setSlowest(link); // where a laser wakes
    }
    return !waking || now - wakingUntilNanos <= 0;
  }

  /** Whether nothing is to be sent now. */
  boolean isQuiet(long now) {
    return waking || now - quietUntilNanos < 0;
  }
}
