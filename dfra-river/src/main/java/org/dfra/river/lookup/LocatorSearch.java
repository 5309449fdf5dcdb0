package org.dfra.river.lookup;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import java.io.IOException;
import java.time.Duration;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.Condition;
import java.util.concurrent.locks.ReentrantLock;
import java.util.function.Consumer;
import net.jini.core.discovery.LookupLocator;
import org.dfra.river.discovery.LocatedRegistrar;
import org.dfra.river.discovery.UnicastDiscovery;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Searches for the lookup service at one locator, at a fixed rate, until it is found, and again
 * when it is discarded. River's own search increases its delay after each failure, up to minutes.
 *
 * <p>Threads: one daemon, {@code dfra-locator-host:port}, from construction to {@link #close}.
 */
final class LocatorSearch implements AutoCloseable {

  private static final Logger LOG = LoggerFactory.getLogger(LocatorSearch.class);

  private final LookupLocator locator;
  private final Duration retry;
  private final Consumer<LocatedRegistrar> finder;
  private final ReentrantLock lock = new ReentrantLock();
  private final Condition changed = lock.newCondition();
  private final Thread thread;

  @GuardedBy("lock")
  private @Nullable LocatedRegistrar found;

  @GuardedBy("lock")
  private boolean closed;

  @GuardedBy("lock")
  private long foundAt;

  private boolean complained; // used by the thread only

  /**
   * @param retry the delay before the next attempt
   * @param finder receives the lookup service, on the search's thread
   */
  LocatorSearch(LookupLocator locator, Duration retry, Consumer<LocatedRegistrar> finder) {
    this.locator = locator;
    this.retry = retry;
    this.finder = finder;
    this.thread =
        new Thread(this::run, "dfra-locator-" + locator.getHost() + ":" + locator.getPort());
    thread.setDaemon(true);
    thread.setContextClassLoader(Thread.currentThread().getContextClassLoader());
  }

  void start() {
    thread.start();
  }

  LookupLocator locator() {
    return locator;
  }

  /** The lookup service at the locator, as far as is known. */
  @Nullable LocatedRegistrar found() {
    lock.lock();
    try {
      return found;
    } finally {
      lock.unlock();
    }
  }

  /** Searches again, if the lost lookup service is the found one. */
  void discard(LocatedRegistrar lost) {
    lock.lock();
    try {
      if (lost.equals(found)) {
        found = null;
        changed.signalAll();
      }
    } finally {
      lock.unlock();
    }
  }

  private void run() {
    try {
      while (awaitNeed()) {
        @Nullable LocatedRegistrar registrar = look();
        lock.lock();
        try {
          if (registrar != null) {
            found = registrar;
            foundAt = System.nanoTime();
          } else if (!closed) {
            changed.await(retry.toNanos(), TimeUnit.NANOSECONDS);
          }
        } finally {
          lock.unlock();
        }
        if (registrar != null) {
          finder.accept(registrar);
        }
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt(); // closed
    }
  }

  /** Waits until a search is needed; false when closed. */
  private boolean awaitNeed() throws InterruptedException {
    lock.lock();
    try {
      boolean again = found != null;
      while (found != null && !closed) {
        changed.await();
      }
      // Limits the rate of calls to a lookup service that is found but fails immediately.
      long wait = foundAt + retry.toNanos() - System.nanoTime();
      while (again && wait > 0 && !closed) {
        wait = changed.awaitNanos(wait);
      }
      return !closed;
    } finally {
      lock.unlock();
    }
  }

  private @Nullable LocatedRegistrar look() {
    try {
      LocatedRegistrar registrar =
          UnicastDiscovery.discover(
                  locator.getHost(), locator.getPort(), LookupTimings.ATTEMPT_TIMEOUT)
              .registrar();
      complained = false;
      return registrar;
    } catch (IOException | ClassNotFoundException | RuntimeException e) {
      if (!complained) {
        complained = true;
        LOG.info(
            "No lookup service answers at {} ({}); it is tried again every {} ms.",
            locator,
            e.toString(),
            retry.toMillis());
      }
      return null;
    }
  }

  @Override
  public void close() {
    lock.lock();
    try {
      closed = true;
      changed.signalAll();
    } finally {
      lock.unlock();
    }
    thread.interrupt();
  }
}
