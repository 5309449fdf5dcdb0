package org.dfra.sim.device;

import java.nio.ByteBuffer;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayDeque;

/**
 * One direction of a serial link, 8N1: a byte arrives with the last of its ten bits. Callers pass
 * the time; it reads no clock. Confined to one thread.
 */
public final class UartLine {

  public static final int FASTEST = 4_000_000;

  private static final long BIT_NANOS_PER_BYTE = 10_000_000_000L;

  /** A device reports slightly late; a larger step back means that the clock was set. */
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

    /** How many of its bytes have arrived, including those already taken. */
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
  private Instant free = Instant.MIN; // when the last bit arrives
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

  /** Baud rate of bytes sent from now on. */
  public int baud() {
    return baud;
  }

  /**
   * Sets the baud rate of bytes sent from now on; queued bytes keep the rate that they had.
   *
   * @param next bits per second, 1 to {@value #FASTEST}
   */
  public void setBaud(int next) {
    baud = checked(next);
  }

  /** Queues bytes; on an idle link the first bit is sent at {@code now}. */
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

  /** Moves the bytes that have arrived by {@code now} to {@code out}, as far as they fit. */
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

  /** Queued bytes. */
  public int waitingBytes() {
    return waitingBytes;
  }

  /** A clock that was set back stalls the link for at most one poll. */
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
