package org.dfra.river.callback;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import java.lang.System.Logger.Level;
import java.net.UnknownHostException;
import java.time.Duration;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.Executor;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import java.util.function.LongSupplier;
import org.dfra.river.access.OwnAddresses;
import org.dfra.river.access.RemoteCaller;
import org.jspecify.annotations.Nullable;

/**
 * Caches the addresses of the hosts that servers are exported at. A name is resolved on a separate
 * thread and never on the calling thread, which dispatches a call and may hold a lock. A name
 * server that does not answer would block every client there.
 *
 * <pre>
 *   not known --look-up--&gt; known, looked up again after {@link #REFRESH_INTERVAL}
 *       '------ fails ------&gt; as before, looked up again after {@link #RETRY_INTERVAL}
 * </pre>
 *
 * <p>A numeric address needs no look-up. A result is valid until the next one arrives.
 *
 * <p>Thread-safe. Threads: one daemon, {@code dfra-own-hosts}, while there is a look-up.
 */
final class AsyncHostResolver {

  /** Looks a host up; may wait for the network. */
  @FunctionalInterface
  interface Resolver {
    OwnAddresses resolve(String host) throws UnknownHostException;
  }

  static final Duration REFRESH_INTERVAL = Duration.ofMinutes(1);
  static final Duration RETRY_INTERVAL = Duration.ofSeconds(5);

  private static final System.Logger LOG = System.getLogger(AsyncHostResolver.class.getName());

  private static final long IDLE_SECONDS = 10;

  private static final class CachedHost {
    @Nullable OwnAddresses own; // guarded by the hosts, like the next fields
    long dueAt; // nanoseconds
    boolean isUnderWay;

    CachedHost(long dueAt) {
      this.dueAt = dueAt;
    }
  }

  private final Resolver resolver;
  private final LongSupplier nanos;
  private final Executor executor;

  @GuardedBy("this")
  private final Map<String, CachedHost> entries = new HashMap<>();

  /**
   * @param nanos monotonic time
   * @param executor runs the look-ups
   */
  AsyncHostResolver(Resolver resolver, LongSupplier nanos, Executor executor) {
    this.resolver = resolver;
    this.nanos = nanos;
    this.executor = executor;
  }

  /** Uses this computer's resolver. */
  static AsyncHostResolver ofSystem() {
    ThreadPoolExecutor thread =
        new ThreadPoolExecutor(
            1,
            1,
            IDLE_SECONDS,
            TimeUnit.SECONDS,
            new LinkedBlockingQueue<>(),
            task -> {
              Thread made = new Thread(task, "dfra-own-hosts");
              made.setDaemon(true);
              made.setContextClassLoader(
                  AsyncHostResolver.class.getClassLoader()); // not a client's
              return made;
            });
    thread.allowCoreThreadTimeOut(true);
    return new AsyncHostResolver(OwnAddresses::exportedAt, System::nanoTime, thread);
  }

  /**
   * The addresses from which this computer calls a server; returns immediately.
   *
   * @param host address or name that the server's proxies carry; one of a few
   * @return empty while the name is not resolved
   */
  Optional<OwnAddresses> addressesOf(String host) {
    if (RemoteCaller.fromHost(host).address() != null) {
      return ofDigits(host);
    }
    CachedHost entry;
    synchronized (this) {
      long now = nanos.getAsLong();
      entry = entries.computeIfAbsent(host, unused -> new CachedHost(now));
      if (entry.isUnderWay || now - entry.dueAt < 0) {
        return Optional.ofNullable(entry.own);
      }
      entry.isUnderWay = true;
    }
    executor.execute(() -> lookUp(host, entry));
    synchronized (this) {
      return Optional.ofNullable(entry.own);
    }
  }

  private static Optional<OwnAddresses> ofDigits(String host) {
    try {
      return Optional.of(OwnAddresses.exportedAt(host));
    } catch (UnknownHostException e) { // an invalid numeric address
      return Optional.empty();
    }
  }

  private void lookUp(String host, CachedHost entry) {
    @Nullable OwnAddresses found = null;
    try {
      found = resolver.resolve(host);
    } catch (UnknownHostException e) {
      LOG.log(Level.DEBUG, "The address of " + host + " is not known now.", e);
    } finally {
      note(entry, found);
    }
  }

  private synchronized void note(CachedHost entry, @Nullable OwnAddresses found) {
    entry.isUnderWay = false;
    if (found != null) {
      entry.own = found;
    }
    entry.dueAt = nanos.getAsLong() + (found == null ? RETRY_INTERVAL : REFRESH_INTERVAL).toNanos();
  }
}
