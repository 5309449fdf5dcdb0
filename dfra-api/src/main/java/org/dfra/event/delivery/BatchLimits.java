package org.dfra.event.delivery;

import java.time.Duration;

/**
 * How many events one call delivers.
 *
 * <p>Beyond these limits the rest waits for the next call. The first event of a call has no limit
 * of bytes: without this it could never be delivered.
 *
 * @param events the most events of a call, at least 1
 * @param bytes the most bytes of a call's events together, as {@link EventSize} estimates them; at
 *     least 1
 * @param slow a call that takes longer is slow: the next one delivers half as many events at most,
 *     so that calls over a slow link stay within their deadline; above zero
 */
public record BatchLimits(int events, long bytes, Duration slow) {

  public BatchLimits {
    if (events < 1 || bytes < 1 || slow.isNegative() || slow.isZero()) {
      throw new IllegalArgumentException(
          "limits of a batch must be above 0, and these are "
              + events
              + " events, "
              + bytes
              + " bytes and "
              + slow);
    }
  }

  /** For a listener that is notified of one event at a time. */
  static final BatchLimits ONE = new BatchLimits(1, 1, Duration.ofDays(1));
}
