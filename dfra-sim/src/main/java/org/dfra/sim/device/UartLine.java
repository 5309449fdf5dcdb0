package org.dfra.sim.device;

import java.nio.ByteBuffer;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayDeque;

/**
 * The sending half of a serial line, 8N1: a byte is through when its ten bits are. Goes by the
 * times it is given and reads no clock. Confined to one thread.
 */
final class UartLine {

  static final int FASTEST = 4_000_000;

  private static final long BIT_NANOS_PER_BYTE = 10_000_000_000L;
  private static final Duration LONGEST_STEP = Duration.ofMinutes(10); // keeps the product in range

  private final int baud;
  private final ArrayDeque<ByteBuffer> waiting = new ArrayDeque<>();
  private int waitingBytes;
  private long credit; // bits × 1e9 that had time to go out, less than those waiting
  private Instant last = Instant.MIN;

  /**
   * @param baud bits per second, 1 to {@value #FASTEST}
   */
  UartLine(int baud) {
    if (baud < 1 || baud > FASTEST) {
      throw new IllegalArgumentException("baud rate " + baud + " is outside 1 to " + FASTEST);
    }
    this.baud = baud;
  }

  /** Puts bytes behind those that wait; on an idle line the first bit goes out at {@code now}. */
  void send(byte[] bytes, Instant now) {
    if (now.isAfter(last)) {
      settle(now);
    }
    waiting.add(ByteBuffer.wrap(bytes));
    waitingBytes += bytes.length;
  }

  /** Moves the bytes that are through by {@code now} to {@code out}, as far as they fit. */
  void take(ByteBuffer out, Instant now) {
    settle(now);
    long through = Math.min(credit / BIT_NANOS_PER_BYTE, out.remaining());
    while (through > 0 && !waiting.isEmpty()) {
      ByteBuffer head = waiting.element();
      out.put(head.get());
      through--;
      credit -= BIT_NANOS_PER_BYTE;
      waitingBytes--;
      if (!head.hasRemaining()) {
        waiting.remove();
      }
    }
    if (waiting.isEmpty()) {
      credit = 0;
    }
  }

  /** Bytes that wait for the line. */
  int waitingBytes() {
    return waitingBytes;
  }

  /** A clock that was set back stops the line for no longer than one step. */
  private void settle(Instant now) {
    if (!waiting.isEmpty() && now.isAfter(last)) {
      Duration step = Duration.between(last, now);
      long nanos = (step.compareTo(LONGEST_STEP) > 0 ? LONGEST_STEP : step).toNanos();
      credit = Math.min(credit + nanos * baud, waitingBytes * BIT_NANOS_PER_BYTE);
    }
    last = now;
  }
}
