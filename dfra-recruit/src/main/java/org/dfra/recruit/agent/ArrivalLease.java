package org.dfra.recruit.agent;

import java.time.Instant;
import java.time.InstantSource;
import org.dfra.lease.ModuleLease;

/**
 * The lease that a requester holds on its helper. It is not renewed: it is the time for which the
 * helper stays. Cancelling it sends a RELEASE, which may be lost; then it lasts to its end.
 */
final class ArrivalLease implements ModuleLease {

  private final Instant expiration;
  private final InstantSource clock;
  private final Runnable giveBack;
  private volatile boolean isOver;

  ArrivalLease(Instant expiration, InstantSource clock, Runnable giveBack) {
    this.expiration = expiration;
    this.clock = clock;
    this.giveBack = giveBack;
  }

  @Override
  public Instant expiration() {
    return expiration;
  }

  @Override
  public boolean isLive() {
    return !isOver && clock.instant().isBefore(expiration);
  }

  /** The helper has left, or another operation releases it. */
  void invalidate() {
    isOver = true;
  }

  @Override
  public void close() {
    if (isLive()) {
      isOver = true;
      giveBack.run();
    }
  }
}
