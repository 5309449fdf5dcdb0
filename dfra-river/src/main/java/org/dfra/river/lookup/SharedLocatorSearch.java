package org.dfra.river.lookup;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import java.io.IOException;
import java.time.Duration;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.function.Consumer;
import net.jini.core.discovery.LookupLocator;
import org.dfra.core.time.BoundedThreads;
import org.dfra.river.call.CallThreads;
import org.dfra.river.discovery.LocatedRegistrar;
import org.dfra.river.discovery.UnicastDiscovery;
import org.dfra.river.identity.ChannelIdentity;
import org.dfra.river.identity.CurrentIdentity;
import org.dfra.time.Scheduler;
import org.dfra.time.Scheduler.ScheduledTask;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The search at one locator, for all modules and directories of this virtual machine. While each of
 * its users has the lookup service, it has no thread and makes no call.
 *
 * <p>Threads: daemons, {@code dfra-locator-n}, one for an attempt in progress, at most {@value
 * #MOST} for all locators, and as many, {@code dfra-relocate-n}, at locators whose last attempt has
 * failed, so that those delay no other; {@code dfra-found-n} notify.
 */
final class SharedLocatorSearch {

  private static final Logger LOG = LoggerFactory.getLogger(SharedLocatorSearch.class);

  /**
   * The largest number of attempts at the same time, for all locators. One that is not answered
   * takes 2 s: a team of which many are out of reach still tries each of them every few seconds.
   */
  static final int MOST = 32;

  private static final int IDLE_SECONDS = 10;
  private static final ThreadPoolExecutor THREADS =
      BoundedThreads.create("dfra-locator-", MOST, IDLE_SECONDS);

  private static final ThreadPoolExecutor REPEATS =
      BoundedThreads.create("dfra-relocate-", MOST, IDLE_SECONDS);

  /** Notify new users, which do not wait for attempts. */
  private static final ThreadPoolExecutor NOTIFIERS = CallThreads.pool("dfra-found-");

  /** Those with users. */
  @GuardedBy("OPEN")
  private static final Map<Shareable, SharedLocatorSearch> OPEN = new HashMap<>();

  /**
   * What users must have in common; the context class loader reads the proxy that is found, which
   * gets the identity.
   */
  private record Shareable(
      String host,
      int port,
      Duration retry,
      @Nullable ClassLoader loader,
      @Nullable ChannelIdentity identity) {}

  /** One user. */
  static final class User {

    private final Consumer<LocatedRegistrar> finder;
    private @Nullable LocatedRegistrar found; // guarded by the shared search

    /**
     * @param finder receives the lookup service, on a thread of the search
     */
    User(Consumer<LocatedRegistrar> finder) {
      this.finder = finder;
    }
  }

  private final Shareable at;

  @GuardedBy("this")
  private final List<User> users = new ArrayList<>();

  @GuardedBy("this")
  private @Nullable LocatedRegistrar found;

  /** When it was found last. */
  @GuardedBy("this")
  private long foundAt;

  /** Whether an attempt is in progress or to come. */
  @GuardedBy("this")
  private boolean isSearching;

  @GuardedBy("this")
  private @Nullable ScheduledTask next;

  @GuardedBy("this")
  private boolean complained;

  /** Whether the last attempt has. */
  @GuardedBy("this")
  private boolean hasFailed;

  private SharedLocatorSearch(Shareable at) {
    this.at = at;
  }

  /** Adds a user to the search at this locator; starts one if there is none. Never waits. */
  static SharedLocatorSearch join(LookupLocator locator, Duration retry, User user) {
    Shareable at =
        new Shareable(
            locator.getHost(),
            locator.getPort(),
            retry,
            Thread.currentThread().getContextClassLoader(),
            CurrentIdentity.get());
    synchronized (OPEN) {
      SharedLocatorSearch search = OPEN.computeIfAbsent(at, SharedLocatorSearch::new);
      search.add(user);
      return search;
    }
  }

  /** Removes a user; the last one ends the search. */
  void leave(User user) {
    synchronized (OPEN) {
      synchronized (this) {
        users.remove(user);
        if (!users.isEmpty()) {
          return;
        }
        if (next != null) {
          next.cancel();
        }
      }
      OPEN.values().remove(this);
    }
  }

  private synchronized void add(User user) {
    users.add(user);
    if (found == null) {
      searchAfter(0);
    } else {
      LocatedRegistrar known = found;
      user.found = known;
      execute(() -> notify(user, known), NOTIFIERS);
    }
  }

  synchronized @Nullable LocatedRegistrar found(User user) {
    return user.found;
  }

  /** Searches again for a user, if the lost lookup service is the one that it has. */
  synchronized void discard(User user, LocatedRegistrar lost) {
    if (!lost.equals(user.found)) {
      return;
    }
    user.found = null;
    if (lost.equals(found)) {
      found = null;
    }
    // Limits the rate of calls to a lookup service that is found but fails immediately.
    searchAfter(foundAt + at.retry().toNanos() - System.nanoTime());
  }

  @GuardedBy("this")
  private void searchAfter(long nanos) {
    if (isSearching || users.isEmpty()) {
      return;
    }
    isSearching = true;
    ThreadPoolExecutor threads = hasFailed ? REPEATS : THREADS;
    if (nanos <= 0) {
      execute(this::search, threads);
    } else {
      next = Scheduler.system().after(nanos, () -> execute(this::search, threads));
    }
  }

  private void execute(Runnable task, ThreadPoolExecutor threads) {
    try {
      threads.execute(
          () -> {
            Thread thread = Thread.currentThread();
            thread.setContextClassLoader(at.loader());
            try {
              CurrentIdentity.runAs(at.identity(), task);
            } finally {
              thread.setContextClassLoader(null);
            }
          });
    } catch (RejectedExecutionException | OutOfMemoryError e) { // no further thread
      LOG.warn(
          "The lookup service at {}:{} cannot be searched for now and is searched for again: {}",
          at.host(),
          at.port(),
          e.toString());
      ScheduledTask unused =
          Scheduler.system().after(at.retry().toNanos(), () -> execute(task, threads));
    }
  }

  private void search() {
    @Nullable LocatedRegistrar registrar = null;
    List<User> informed = new ArrayList<>();
    try {
      registrar = look();
    } finally {
      if (registrar == null) {
        searchAgain(); // also after an error
      }
    }
    if (registrar == null) {
      return;
    }
    LocatedRegistrar fresh = registrar;
    synchronized (this) {
      isSearching = false;
      hasFailed = false;
      found = fresh;
      foundAt = System.nanoTime();
      for (User each : users) {
        if (!fresh.equals(each.found)) {
          each.found = fresh;
          informed.add(each);
        }
      }
    }
    informed.forEach(each -> notify(each, fresh));
  }

  private synchronized void searchAgain() {
    isSearching = false;
    hasFailed = true;
    searchAfter(at.retry().toNanos());
  }

  private static void notify(User user, LocatedRegistrar found) {
    try {
      user.finder.accept(found);
    } catch (RuntimeException e) { // the other users are informed all the same
      LOG.warn("A lookup service that was found could not be used: {}", e.toString(), e);
    }
  }

  private @Nullable LocatedRegistrar look() {
    try {
      LocatedRegistrar registrar =
          UnicastDiscovery.discover(at.host(), at.port(), LookupTimings.ATTEMPT_TIMEOUT)
              .registrar();
      synchronized (this) {
        complained = false;
      }
      return registrar;
    } catch (IOException | ClassNotFoundException | RuntimeException e) {
      complain(e);
      return null;
    }
  }

  private synchronized void complain(Exception e) {
    if (!complained && !users.isEmpty()) {
      complained = true;
      LOG.info(
          "No lookup service answers at jini://{}:{}/ ({}); it is tried again every {} ms.",
          at.host(),
          at.port(),
          e.toString(),
          at.retry().toMillis());
    }
  }
}
