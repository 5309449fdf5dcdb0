package org.dfra.river.identity;

import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.util.Optional;

/**
 * A clock that is never before the latest time that is known: one that the authority has signed, or
 * one that this computer's clock has shown. If this computer's clock is before it, the clock was
 * not set, and the latest known time stands still in its place: what had expired then stays
 * expired. Thread-safe.
 */
public final class FlooredClock implements InstantSource {

  /** A clock that is behind by less was corrected, and not lost. */
  public static final Duration TOLERANCE = Duration.ofMinutes(5);

  private final InstantSource clock;
  private final Instant latest;
  private volatile Instant floor; // written under this

  /**
   * @param clock this computer's
   * @param floor the latest time that is known
   * @param latest a time that the floor never passes, such as the end of the own certificate: a
   *     clock that was once wrong, here or at the authority, could otherwise set it to any
   */
  public FlooredClock(InstantSource clock, Instant floor, Instant latest) {
    this.clock = clock;
    this.latest = latest;
    this.floor = floor.isBefore(latest) ? floor : latest;
  }

  /** The time by which certificates are judged. */
  @Override
  public Instant instant() {
    Instant now = clock.instant();
    Instant known = floor;
    return now.isBefore(known) ? known : now;
  }

  /** The time; empty if this computer's clock was not set. */
  public Optional<Instant> time() {
    return isSet() ? Optional.of(instant()) : Optional.empty();
  }

  /** Whether this computer's clock was set. */
  public boolean isSet() {
    return !clock.instant().isBefore(floor.minus(TOLERANCE));
  }

  /** What this computer's clock shows. */
  public Instant shown() {
    return clock.instant();
  }

  /** The latest time that is known. */
  public Instant floor() {
    return floor;
  }

  /**
   * Learns that a time has passed, since it was signed by somebody who is believed, or since this
   * computer's clock shows it.
   *
   * @return whether the floor is that or later now
   */
  public synchronized boolean learn(Instant passed) {
    Instant most = passed.isBefore(latest) ? passed : latest;
    if (floor.isBefore(most)) {
      floor = most;
    }
    return !floor.isBefore(passed);
  }
}
