package org.dfra.sim.device;

import java.nio.ByteBuffer;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayDeque;

/**
 * One direction of a serial line, 8N1: a byte is through when its ten bits are. Goes by the times
 * it is given and reads no clock. Confined to one thread.
 */
public final class UartLine {

  static final int FASTEST = 4_000_000;

  private static final long BIT_NANOS_PER_BYTE = 10_000_000_000L;

  /** A device tells of a moment a little later; further back goes only a clock that is set. */
  private static final Duration LATEST = Duration.ofSeconds(10);

  /** Bytes that follow each other without a gap, at one speed. */
  private static final class Burst {
    final ByteBuffer bytes;
    final int baud;
    Instant begin; // of its first bit
    Instant end; // of its last bit

    Burst(byte[] bytes, int baud, Instant begin) {
      this.bytes = ByteBuffer.wrap(bytes);
      this.baud = baud;
      this.begin = begin;
      this.end = begin.plusNanos((bytes.length * BIT_NANOS_PER_BYTE + baud - 1) / baud);
    }

    /** How many of its bytes are through, those that were taken among them. */
    int through(Instant now) {
      if (!now.isBefore(end)) {
        return bytes.limit();
      }
      return now.isBefore(begin)
          ? 0
          : (int) (Duration.between(begin, now).toNanos() * baud / BIT_NANOS_PER_BYTE);
    }
  }

  private final ArrayDeque<Burst> waiting = new ArrayDeque<>();
  private int baud;
  private int waitingBytes;
  private Instant free = Instant.MIN; // when the last bit of all is through
  private Instant last = Instant.MIN;

  /**
   * @param baud bits per second, 1 to {@value #FASTEST}
   */
  public UartLine(int baud) {
    this.baud = checked(baud);
  }

  private static int checked(int baud) {
    if (baud < 1 || baud > FASTEST) {
      throw new IllegalArgumentException("baud rate " + baud + " is outside 1 to " + FASTEST);
    }
    return baud;
  }

  /** Bits per second of what is sent from now on. */
  public int baud() {
    return baud;
  }

  /**
   * Sets the speed of what is sent from now on; what was sent before goes out at the speed it had.
   *
   * @param next bits per second, 1 to {@value #FASTEST}
   */
  public void setBaud(int next) {
    baud = checked(next);
  }

  /** Puts bytes behind those that wait; on an idle line the first bit goes out at {@code now}. */
  public void send(byte[] bytes, Instant now) {
    if (waiting.isEmpty()) {
      last = now;
      if (free.isAfter(now.plus(LATEST))) {
        free = now;
      }
    }
    Burst burst = new Burst(bytes, baud, now.isAfter(free) ? now : free);
    waiting.add(burst);
    waitingBytes += bytes.length;
    free = burst.end;
  }

  /** Moves the bytes that are through by {@code now} to {@code out}, as far as they fit. */
  public void drainTo(ByteBuffer out, Instant now) {
    limitBacklog(now);
    for (Burst head = waiting.peek(); head != null; head = waiting.peek()) {
      int count = Math.min(head.through(now) - head.bytes.position(), out.remaining());
      out.put(head.bytes.slice(head.bytes.position(), count));
      head.bytes.position(head.bytes.position() + count);
      waitingBytes -= count;
      if (head.bytes.hasRemaining()) {
        return;
      }
      waiting.remove();
    }
  }

  /** Bytes that wait for the line. */
  public int waitingBytes() {
    return waitingBytes;
  }

  /** A clock that was set back stops the line for no longer than from one look to the next. */
  private void limitBacklog(Instant now) {
    if (now.isBefore(last)) {
      Duration back = Duration.between(now, last);
      for (Burst burst : waiting) {
        burst.begin = burst.begin.minus(back);
        burst.end = burst.end.minus(back);
      }
      free = free.minus(back);
    }
    last = now;
  }
}
