package org.dfra.drivers.laser.lms;

import java.io.IOException;
import java.time.Duration;
import java.util.Optional;
import org.dfra.drivers.link.SerialLink;
import org.jspecify.annotations.Nullable;

/**
 * Keeps this end of the link at the laser's baud rate, and reports when nothing must be sent.
 *
 * <pre>
 *   IDLE --laser will change its rate--&gt; SWITCHED --followed--&gt; SETTLING --250 ms--&gt; IDLE
 *    |                                                                                ^
 *    '--laser resets itself--&gt; WAKING, at the lowest rate --it has started, or 60 s---'
 * </pre>
 *
 * <p>Confined to the reader thread.
 */
final class LmsBaudSynchronizer {

  private static final Duration SETTLING_TIME = Duration.ofMillis(250);

  /** Maximum time that a laser takes to start. */
  static final Duration WAKING = Duration.ofSeconds(60);

  private final LmsBaudSearch speeds;
  private boolean switched; // the far end has changed its rate, this end follows
  private boolean waking;
  private long wakingUntilNanos;
  private long quietUntilNanos;

  LmsBaudSynchronizer(Optional<LmsBaud> target) {
    this.speeds = new LmsBaudSearch(target);
  }

  LmsBaudSearch speeds() {
    return speeds;
  }

  /** Sets this end to the next rate of the search; see {@link LmsBaudSearch#next}. */
  @Nullable String search(SerialLink link, long now) {
    switched = false;
    waking = false;
    quietUntilNanos = now;
    return speeds.next(link);
  }

  /** The laser has reported that it will change its rate. */
  void switched() {
    switched = true;
  }

  /** The laser has reported that it will reset. */
  void resets(long now) {
    waking = true;
    wakingUntilNanos = now + WAKING.toNanos();
  }

  /** The laser has reported that it has started. */
  void poweredOn() {
    waking = false;
    speeds.restart();
  }

  boolean isPoweringOn() {
    return waking;
  }

  /**
   * Performs the rate changes that are due.
   *
   * @return false if the laser has not started in time and must be searched
   */
  boolean update(SerialLink link, long now) throws IOException {
    if (switched) {
      switched = false;
      speeds.followWanted(link);
      quietUntilNanos = now + SETTLING_TIME.toNanos();
    }
    if (waking && !speeds.isAtSlowest()) {
      speeds.setSlowest(link); // the power-on rate
    }
    return !waking || now - wakingUntilNanos <= 0;
  }

  /** Whether nothing may be sent now. */
  boolean isQuiet(long now) {
    return waking || now - quietUntilNanos < 0;
  }
}
