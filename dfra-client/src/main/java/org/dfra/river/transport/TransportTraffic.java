package org.dfra.river.transport;

import java.util.concurrent.atomic.LongAdder;
import org.jspecify.annotations.Nullable;

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
  private static final LongAdder BYTES_OF_NETWORK = new LongAdder();

  /** Of threads that have asked for it. */
  private static final ThreadLocal<long @Nullable []> OF_THREAD = new ThreadLocal<>();

  private static volatile boolean isCountedByThread;

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

  /**
   * The bytes that this virtual machine has sent to and received from other computers since its
   * start: those of connections whose ends have different addresses.
   */
  public static long bytesOfNetwork() {
    return BYTES_OF_NETWORK.sum();
  }

  /**
   * The bytes that the current thread itself has sent and received since it first called this: of
   * the calls that it makes, and not of those that it serves.
   */
  public static long bytesOfThread() {
    long @Nullable [] own = OF_THREAD.get();
    if (own == null) {
      own = new long[1];
      OF_THREAD.set(own);
      isCountedByThread = true;
    }
    return own[0];
  }

  static void countSent(int bytes, boolean leavesComputer) {
    BYTES_SENT.add(bytes);
    count(bytes, leavesComputer);
  }

  static void countReceived(int bytes, boolean leavesComputer) {
    BYTES_RECEIVED.add(bytes);
    count(bytes, leavesComputer);
  }

  private static void count(int bytes, boolean leavesComputer) {
    if (leavesComputer) {
      BYTES_OF_NETWORK.add(bytes);
    }
    if (isCountedByThread) {
      long @Nullable [] own = OF_THREAD.get();
      if (own != null) {
        own[0] += bytes;
      }
    }
  }
}
