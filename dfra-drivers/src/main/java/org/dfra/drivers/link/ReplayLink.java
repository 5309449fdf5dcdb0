package org.dfra.drivers.link;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import java.io.IOException;
import java.io.RandomAccessFile;
import java.time.Duration;
import java.util.concurrent.locks.Condition;
import java.util.concurrent.locks.ReentrantLock;

/**
 * Replays a recording. A byte is available when its last bit would have arrived; the first read
 * starts the replay.
 */
final class ReplayLink implements SerialLink {

  private static final double BIT_NANOS_PER_BYTE = 10e9;

  private final ReplayAddress address;
  private final Ticker ticker;
  private final double nanosPerByte;
  private final long size;

  private final ReentrantLock lock = new ReentrantLock();
  private final Condition closed;

  @GuardedBy("lock")
  private final RandomAccessFile file;

  @GuardedBy("lock")
  private boolean open = true;

  @GuardedBy("lock")
  private boolean begun;

  @GuardedBy("lock")
  private long beginNanos;

  @GuardedBy("lock")
  private long played;

  ReplayLink(ReplayAddress address, Ticker ticker) throws IOException {
    this.address = address;
    this.ticker = ticker;
    this.closed = ticker.newCondition(lock);
    this.nanosPerByte =
        address.pace() == 0 ? 0 : BIT_NANOS_PER_BYTE / (address.baud() * address.pace());
    this.file = new RandomAccessFile(address.file().toFile(), "r");
    this.size = file.length();
  }

  @Override
  public int read(byte[] buffer, int offset, int length, Duration timeout) {
    lock.lock();
    try {
      long entered = ticker.nanos();
      if (!begun) {
        begun = true;
        beginNanos = entered;
      }
      while (open) {
        if (played >= size && !address.loop()) {
          return lose();
        }
        long now = ticker.nanos();
        int due = (int) Math.min(length, dueAt(now));
        if (due > 0) {
          return take(buffer, offset, due);
        }
        long left = timeout.toNanos() - (now - entered);
        if (left <= 0) {
          return 0;
        }
        long next = beginNanos + (long) Math.ceil((played + 1) * nanosPerByte) - now;
        ticker.await(closed, Math.min(left, Math.max(1, next)));
      }
      return -1;
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return lose();
    } catch (IOException e) {
      return lose();
    } finally {
      lock.unlock();
    }
  }

  @GuardedBy("lock")
  private long dueAt(long now) {
    return nanosPerByte == 0
        ? Long.MAX_VALUE
        : (long) Math.floor((now - beginNanos) / nanosPerByte) - played;
  }

  @GuardedBy("lock")
  private int take(byte[] buffer, int offset, int due) throws IOException {
    int count = file.read(buffer, offset, due);
    if (count < 0 && address.loop()) {
      file.seek(0);
      count = file.read(buffer, offset, due);
    }
    if (count < 0) {
      return lose();
    }
    played += count;
    return count;
  }

  private int lose() {
    close();
    return -1;
  }

  @Override
  public void write(byte[] bytes) throws IOException {
    if (!isOpen()) {
      throw new IOException(address + ": the replay has ended");
    }
  }

  @Override
  public boolean isOpen() {
    lock.lock();
    try {
      return open;
    } finally {
      lock.unlock();
    }
  }

  @Override
  public void close() {
    lock.lock();
    try {
      open = false;
      closed.signalAll();
      file.close();
    } catch (IOException e) {
      // it was opened only for reading
    } finally {
      lock.unlock();
    }
  }

  @Override
  public String toString() {
    return address.toString();
  }
}
