package org.dfra.river.call;

import net.jini.jeri.OutboundRequest;
import org.jspecify.annotations.Nullable;

/**
 * One call on its way, shared between the caller that may give it up and the thread that waits for
 * its answer.
 */
final class CallInFlight {

  private static final ThreadLocal<@Nullable CallInFlight> CURRENT = new ThreadLocal<>();

  private @Nullable OutboundRequest request;
  private boolean abandoned;
  private boolean ended;

  /** Makes this the call of the current thread while {@code body} runs. */
  <T extends @Nullable Object> T carry(Body<T> body) throws Throwable {
    CURRENT.set(this);
    try {
      return body.run();
    } finally {
      CURRENT.remove();
    }
  }

  /** Tells the current thread's call, if it has one, by which request it leaves. */
  static void leaving(OutboundRequest request) {
    @Nullable CallInFlight call = CURRENT.get();
    if (call != null) {
      call.setRequest(request);
    }
  }

  private void setRequest(OutboundRequest leaving) {
    boolean tooLate;
    synchronized (this) {
      request = leaving;
      tooLate = abandoned;
    }
    if (tooLate) {
      leaving.abort();
    }
  }

  /**
   * Gives the call up: the request is aborted, its thread comes free.
   *
   * @return false if the call had ended before
   */
  boolean abandon() {
    OutboundRequest leaving;
    synchronized (this) {
      if (ended) {
        return false;
      }
      abandoned = true;
      leaving = request;
    }
    if (leaving != null) {
      leaving.abort();
    }
    return true;
  }

  /**
   * Notes that the call's thread is free again.
   *
   * @return whether the call had been given up before
   */
  synchronized boolean end() {
    ended = true;
    return abandoned;
  }

  /** Whether a connection was found for the call. */
  synchronized boolean hasLeft() {
    return request != null;
  }

  /**
   * Whether bytes of the call may have reached the server. Final once the call was abandoned or has
   * ended; before that, its first bytes may leave right after the answer.
   */
  synchronized boolean mayHaveRun() {
    return request != null && request.getDeliveryStatus();
  }

  /** What a call does. */
  interface Body<T extends @Nullable Object> {
    T run() throws Throwable;
  }
}
