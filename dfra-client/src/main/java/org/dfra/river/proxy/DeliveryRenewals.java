package org.dfra.river.proxy;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import java.util.OptionalLong;

/**
 * Determines from the calls that deliver events when the server has renewed the subscription's
 * lease.
 *
 * <p>The server renews it after each call that succeeded, and says so in the next call. This
 * computer received the former one before that, so the lease ends at the server not before its
 * duration has passed since then. A call of which the server does not say so proves nothing: its
 * answer may have been lost.
 */
final class DeliveryRenewals {

  @GuardedBy("this")
  private boolean any;

  @GuardedBy("this")
  private long lastCall;

  @GuardedBy("this")
  private long lastReceived;

  /**
   * Receives a call.
   *
   * @param call its number
   * @param renewed the number of the call after which the lease was renewed, as the server says
   * @param now the time, nanoseconds of the scheduler
   * @return a time after which the server has renewed the lease, if this call proves one
   */
  synchronized OptionalLong received(long call, long renewed, long now) {
    OptionalLong proof =
        any && renewed == lastCall && call != renewed
            ? OptionalLong.of(lastReceived)
            : OptionalLong.empty();
    if (!any || call != lastCall) { // a call that comes twice was received the first time
      any = true;
      lastCall = call;
      lastReceived = now;
    }
    return proof;
  }
}
