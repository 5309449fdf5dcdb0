package org.dfra.sim.device;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import java.io.IOException;
import java.time.Duration;
import java.time.InstantSource;
import java.util.concurrent.locks.Condition;
import java.util.concurrent.locks.ReentrantLock;
import org.dfra.drivers.link.SerialLink;
import org.dfra.drivers.link.SimLinkRegistry.SimAddress;
import org.dfra.drivers.link.Ticker;

/** The computer's end of a link to a simulated device. */
final class SimLink implements SerialLink {

  /** Maximum unread bytes; bytes beyond that are lost. */
  private static final int ROOM = 65_536;

  /** Polls of the device for which bytes may wait for more. */
  private static final int LONGEST_HOLD = 4;

  private final SimAddress address;
  private final Ticker ticker;
  private final Cable cable;
  private final InstantSource clock;

  private final ReentrantLock lock = new ReentrantLock();
  private final Condition changed;

  @GuardedBy("lock")
  private final byte[] unread = new byte[ROOM];

  @GuardedBy("lock")
  private int filled;

  // since the first of them arrived, or the reader was woken
  @GuardedBy("lock")
  private int polls;

  @GuardedBy("lock")
  private boolean open = true;

  @GuardedBy("lock")
  private boolean lost;

  /**
   * @param ticker gives the time for waits
   * @param cable receives what is written
   * @param clock the same time
   */
  SimLink(SimAddress address, Ticker ticker, Cable cable, InstantSource clock) {
    this.address = address;
    this.ticker = ticker;
    this.cable = cable;
    this.clock = clock;
    this.changed = ticker.newCondition(lock);
  }

  /**
   * Accepts the device's bytes, if any.
   *
   * @param paused whether the line is idle now, so that the reader gets the bytes at once;
   *     otherwise it gets them with those that follow, {@value #LONGEST_HOLD} polls later at the
   *     latest
   */
  void deliver(byte[] bytes, boolean paused) {
    lock.lock();
    try {
      int count = Math.min(bytes.length, ROOM - filled);
      System.arraycopy(bytes, 0, unread, filled, count);
      filled += count;
      polls = filled == 0 ? 0 : polls + 1;
      if (filled > 0 && (paused || polls >= LONGEST_HOLD)) {
        polls = 0;
        changed.signalAll();
      }
    } finally {
      lock.unlock();
    }
  }

  /** The device is disconnected; received bytes can still be read. */
  void disconnect() {
    lock.lock();
    try {
      lost = true;
      changed.signalAll();
    } finally {
      lock.unlock();
    }
  }

  @Override
  public int read(byte[] buffer, int offset, int length, Duration timeout) {
    lock.lock();
    try {
      long begin = ticker.nanos();
      long left = timeout.toNanos();
      while (open && !lost && filled == 0 && left > 0) {
        ticker.await(changed, left);
        left = timeout.toNanos() - (ticker.nanos() - begin);
      }
      return take(buffer, offset, length);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      open = false;
      return -1;
    } finally {
      lock.unlock();
    }
  }

  @GuardedBy("lock")
  private int take(byte[] buffer, int offset, int length) {
    if (!open || (lost && filled == 0)) {
      open = false;
      return -1;
    }
    int count = Math.min(length, filled);
    System.arraycopy(unread, 0, buffer, offset, count);
    System.arraycopy(unread, count, unread, 0, filled - count);
    filled -= count;
    return count;
  }

  @Override
  public void write(byte[] bytes) throws IOException {
    requireOpen();
    cable.send(bytes.clone(), clock.instant());
  }

  /** {@inheritDoc} Until then it uses the device's baud rate. */
  @Override
  public void setBaud(int baud) throws IOException {
    requireOpen();
    if (baud < 1 || baud > UartLine.FASTEST) {
      throw new IOException(
          address + ": baud rate " + baud + " is outside 1 to " + UartLine.FASTEST);
    }
    cable.setPortBaud(baud);
  }

  private void requireOpen() throws IOException {
    if (!isOpen()) {
      throw new IOException(address + ": the simulated device was lost, or the link was closed");
    }
  }

  @Override
  public boolean isOpen() {
    lock.lock();
    try {
      return open && !lost;
    } finally {
      lock.unlock();
    }
  }

  @Override
  public void close() {
    lock.lock();
    try {
      open = false;
      changed.signalAll();
    } finally {
      lock.unlock();
    }
  }

  @Override
  public String toString() {
    return address.toString();
  }
}
