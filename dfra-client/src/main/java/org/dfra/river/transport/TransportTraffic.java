package org.dfra.river.transport;

import java.util.concurrent.atomic.LongAdder;

/**
 * What this virtual machine has sent and received by the transport since its start. Calls by
 * River's own endpoints and the discovery of lookup services are not counted.
 *
 * @param callsSent requests for which a connection was obtained, also those that failed afterwards
 * @param callsServed requests that a server's object in this virtual machine was called for
 * @param bytesSent bytes handed to the operating system, with the transport's own headers
 * @param bytesReceived bytes received, likewise
 */
public record TransportTraffic(
    long callsSent, long callsServed, long bytesSent, long bytesReceived) {

  private static final LongAdder CALLS_SENT = new LongAdder();
  private static final LongAdder CALLS_SERVED = new LongAdder();
  private static final LongAdder BYTES_SENT = new LongAdder();
  private static final LongAdder BYTES_RECEIVED = new LongAdder();

  /** The traffic so far. The four numbers are not of exactly the same time. */
  public static TransportTraffic now() {
    return new TransportTraffic(
        CALLS_SENT.sum(), CALLS_SERVED.sum(), BYTES_SENT.sum(), BYTES_RECEIVED.sum());
  }

  /** The traffic between an earlier time and this one. */
  public TransportTraffic since(TransportTraffic earlier) {
    return new TransportTraffic(
        callsSent - earlier.callsSent,
        callsServed - earlier.callsServed,
        bytesSent - earlier.bytesSent,
        bytesReceived - earlier.bytesReceived);
  }

  static void countCallSent() {
    CALLS_SENT.increment();
  }

  static void countCallServed() {
    CALLS_SERVED.increment();
  }

  static void countSent(int bytes) {
    BYTES_SENT.add(bytes);
  }

  /**
   * Counts received bytes.
   *
   * @param bytes the result of a read; -1 at the end
   */
  static void countReceived(int bytes) {
    if (bytes > 0) {
      BYTES_RECEIVED.add(bytes);
    }
  }
}
