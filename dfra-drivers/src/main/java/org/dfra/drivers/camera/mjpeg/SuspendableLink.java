package org.dfra.drivers.camera.mjpeg;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import java.io.IOException;
import java.time.Duration;
import java.util.concurrent.locks.Condition;
import java.util.concurrent.locks.ReentrantLock;
import org.dfra.drivers.link.LinkKeeper;
import org.dfra.drivers.link.SerialLink;
import org.dfra.drivers.link.Ticker;
import org.jspecify.annotations.Nullable;

/**
 * A link that can be suspended: its connection is closed, but the link does not count as lost.
 * {@link #suspend}, {@link #resume}, reading and writing are confined to one thread, the reader;
 * any thread may close it.
 */
final class SuspendableLink implements SerialLink {

  private final LinkKeeper.Source source;
  private final Ticker ticker;
  private final String name;
  private final ReentrantLock lock = new ReentrantLock();
  private final Condition closing;

  // null while suspended
  @GuardedBy("lock")
  private @Nullable SerialLink connection;

  @GuardedBy("lock")
  private boolean closed;

  private SuspendableLink(LinkKeeper.Source source, Ticker ticker, SerialLink first) {
    this.source = source;
    this.ticker = ticker;
    this.closing = ticker.newCondition(lock);
    this.name = first.toString();
    this.connection = first;
  }

  /** Connects. */
  static SuspendableLink open(LinkKeeper.Source source, Ticker ticker) throws IOException {
    return new SuspendableLink(source, ticker, source.open());
  }

  /** Closes the connection until {@link #resume}. */
  void suspend() {
    SerialLink last;
    lock.lock();
    try {
      last = connection;
      connection = null;
    } finally {
      lock.unlock();
    }
    if (last != null) {
      last.close();
    }
  }

  /** Reconnects, unless it is connected. */
  void resume() throws IOException {
    if (current() != null) {
      return;
    }
    SerialLink next = source.open();
    lock.lock();
    try {
      if (!closed) {
        connection = next;
        return;
      }
    } finally {
      lock.unlock();
    }
    next.close();
    throw new IOException(name + ": closed meanwhile");
  }

  /** Whether the link is suspended. */
  boolean isResting() {
    return current() == null;
  }

  private @Nullable SerialLink current() {
    lock.lock();
    try {
      return connection;
    } finally {
      lock.unlock();
    }
  }

  @Override
  public int read(byte[] buffer, int offset, int length, Duration timeout) {
    SerialLink now = current();
    return now == null ? idle(timeout) : now.read(buffer, offset, length, timeout);
  }

  private int idle(Duration timeout) {
    lock.lock();
    try {
      if (!closed) {
        ticker.await(closing, timeout.toNanos()); // or less: the reader checks again
      }
      return closed ? -1 : 0;
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return -1;
    } finally {
      lock.unlock();
    }
  }

  @Override
  public void write(byte[] bytes) throws IOException {
    SerialLink now = current();
    if (now == null) {
      throw new IOException(name + ": it rests");
    }
    now.write(bytes);
  }

  @Override
  public boolean isOpen() {
    lock.lock();
    try {
      return !closed && (connection == null || connection.isOpen());
    } finally {
      lock.unlock();
    }
  }

  @Override
  public void close() {
    lock.lock();
    try {
      closed = true;
      closing.signalAll();
      if (connection != null) {
        connection.close();
      }
    } finally {
      lock.unlock();
    }
  }

  @Override
  public String toString() {
    return name;
  }
}
