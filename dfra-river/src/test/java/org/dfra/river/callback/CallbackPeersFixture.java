package org.dfra.river.callback;

import org.dfra.event.delivery.DeliveryPool;
import org.dfra.time.Scheduler;

/** Peers of their own for tests of other packages. */
public final class CallbackPeersFixture {

  private CallbackPeersFixture() {}

  /** Peers that share nothing with those of this virtual machine, and live by this time. */
  public static CallbackLimiter by(Scheduler time) {
    return new CallbackLimiter(new DeliveryPool(1, time), time);
  }
}
