package org.dfra.drivers.link;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import java.io.IOException;
import java.time.Duration;
import java.util.concurrent.locks.Condition;
import java.util.concurrent.locks.ReentrantLock;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;

/**
 * Keeps a link open: opens it, reads it, and reopens it when it is lost, with a growing wait
 * between failed attempts.
 *
 * <p>It owns one thread, the reader, which owns the link and calls the {@link LinkHandler}. {@link
 * #start} starts the reader; {@link #close} stops it and returns when it has ended. Both do nothing
 * the second time, and a keeper that is closed before it is started never starts.
 *
 * <p>It logs changes, not attempts: once when the device answers, and once for each new reason why
 * it does not.
 */
public final class LinkKeeper implements ReopeningLink {

  /** Opens the link. */
  @FunctionalInterface
  public interface Source {

    /**
     * Opens the link; may block for a few seconds, and returns soon when its thread is interrupted.
     *
     * @throws IOException if it cannot be opened
     */
    SerialLink open() throws IOException;
  }

  static final Duration READ_TIMEOUT = Duration.ofMillis(100);
  private static final Duration LONGEST_END = Duration.ofSeconds(5);
  private static final int BUFFER_BYTES = 4096;

  private final Source source;
  private final LinkHandler user;
  private final BackOff backOff;
  private final Ticker ticker;
  private final Logger log;
  private final Thread reader;

  private final ReentrantLock lock = new ReentrantLock();
  private final Condition closing;

  @GuardedBy("lock")
  private boolean started;

  @GuardedBy("lock")
  private @Nullable SerialLink link;

  private boolean
      hurried; // guarded by lock; the compiler does not see that a finally block holds it

  private volatile boolean closed;
  private volatile String fault = "it has not been opened yet";

  // confined to the reader
  private int failures;
  private @Nullable String logged = "";

  /**
   * @param name name of the link's owner; the thread is called {@code name reader}
   * @param source opens the link
   * @param user handles the link
   * @param backOff how long to wait between attempts
   * @param ticker the clock for waits
   * @param log where changes are logged
   */
  public LinkKeeper(
      String name, Source source, LinkHandler user, BackOff backOff, Ticker ticker, Logger log) {
    this.source = source;
    this.user = user;
    this.backOff = backOff;
    this.ticker = ticker;
    this.log = log;
    this.closing = ticker.newCondition(lock);
    this.reader = ticker.newThread(name + " reader", this::run);
  }

  /** Starts the reader and returns at once. */
  @Override
  public void start() {
    lock.lock();
    try {
      if (!started && !closed) {
        started = true;
        reader.start();
      }
    } finally {
      lock.unlock();
    }
  }

  /** Whether the link is open now. */
  public boolean isOpen() {
    lock.lock();
    try {
      return link != null && link.isOpen();
    } finally {
      lock.unlock();
    }
  }

  /** Why the link was not open when it was not, as a clause. */
  public String fault() {
    return fault;
  }

  /** Closes the link, if it is open, and reopens it immediately. Returns before that is done. */
  public void reopen() {
    lock.lock();
    try {
      hurried = true;
      closing.signalAll();
      if (link != null) {
        link.close();
      }
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
      if (link != null) {
        link.close();
      }
      if (!started || Thread.currentThread() == reader) {
        return;
      }
    } finally {
      lock.unlock();
    }
    reader.interrupt(); // it may be connecting
    boolean ended = false;
    try {
      ended = ticker.join(reader, LONGEST_END);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
    if (!ended) {
      log.warn(
          "{} has not ended within {} s and is left behind",
          reader.getName(),
          LONGEST_END.toSeconds());
    }
  }

  private void run() {
    while (!closed) {
      boolean unused = Thread.interrupted(); // a pending interrupt would close every new connection
      String reason;
      try (SerialLink opened = source.open()) {
        reason = adopt(opened) ? serve(opened) : "closed";
      } catch (IOException e) {
        reason = String.valueOf(e.getMessage());
      } catch (RuntimeException | Error e) { // whatever the error, the link must be kept
        log.error("the driver failed, its link is opened again: {}", e.toString(), e);
        reason = "the driver failed: " + e;
      }
      adopt(null);
      if (!closed) {
        lose(reason);
      }
    }
  }

  /** Makes {@code opened} the link that {@link #close} closes; false when already closed. */
  private boolean adopt(@Nullable SerialLink opened) {
    lock.lock();
    try {
      link = opened;
      return !closed;
    } finally {
      lock.unlock();
    }
  }

  /** Reads until the link is lost or the handler gives it up; returns why. */
  private String serve(SerialLink opened) throws IOException {
    user.opened(opened);
    byte[] buffer = new byte[BUFFER_BYTES];
    while (!closed) {
      int count = opened.read(buffer, 0, buffer.length, user.pollInterval());
      if (count < 0) {
        return opened + ": the device is lost";
      }
      if (count > 0 && user.received(buffer, count)) {
        answered(opened);
      }
      String complaint = user.periodic(opened);
      if (complaint != null) {
        return opened + ": " + complaint;
      }
    }
    return "closed";
  }

  private void answered(SerialLink opened) {
    failures = 0;
    if (logged != null) {
      logged = null;
      log.info("{}: the device answers", opened);
    }
  }

  private void lose(String reason) {
    if (!reason.equals(logged)) {
      logged = reason;
      log.warn("{}; trying again until it answers", reason);
    }
    failures++;
    fault = reason;
    try {
      user.lost(reason);
    } catch (RuntimeException | Error e) { // whatever the error, the link must be reopened
      log.error("the driver failed when its link was lost: {}", e.toString(), e);
      fault = reason + "; and the driver failed: " + e;
    }
    pause(backOff.after(failures).toNanos());
  }

  private void pause(long nanos) {
    lock.lock();
    try {
      long begin = ticker.nanos();
      long left = nanos;
      while (!closed && !hurried && left > 0) {
        ticker.await(closing, left);
        left = nanos - (ticker.nanos() - begin);
      }
    } catch (InterruptedException e) {
      // closed is set, or the wait is ended early
    } finally {
      hurried = false;
      lock.unlock();
    }
  }

  /**
   * How long to wait before the next attempt: the initial wait, doubled each time, up to the
   * maximum.
   *
   * @param initial the initial wait, longer than 0
   * @param max the maximum wait, at least {@code initial}
   */
  public record BackOff(Duration initial, Duration max) {

    public BackOff {
      if (initial.isNegative() || initial.isZero()) {
        throw new IllegalArgumentException("first wait " + initial + " is not longer than 0");
      }
      if (max.compareTo(initial) < 0) {
        throw new IllegalArgumentException("longest wait " + max + " < first wait " + initial);
      }
    }

    /**
     * The wait after a number of consecutive failures.
     *
     * @param failures failures since the last success, at least 1
     */
    public Duration after(int failures) {
      int doublings = Math.min(Math.max(0, failures - 1), 30);
      long nanos = initial.toNanos();
      return nanos > max.toNanos() >> doublings ? max : Duration.ofNanos(nanos << doublings);
    }
  }
}
