package org.dfra.core.directory;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import java.lang.reflect.Proxy;
import java.time.Duration;
import java.time.InstantSource;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.UUID;
import java.util.concurrent.Executor;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.locks.Condition;
import java.util.concurrent.locks.ReentrantLock;
import java.util.function.Supplier;
import org.dfra.directory.DirectoryListener;
import org.dfra.directory.DirectoryRegistration;
import org.dfra.directory.ModuleDirectory;
import org.dfra.directory.ModuleListing;
import org.dfra.directory.ModuleQuery;
import org.dfra.directory.Persona;
import org.dfra.module.Module;
import org.dfra.persona.ModuleAttributes;
import org.dfra.time.Scheduler;
import org.jspecify.annotations.Nullable;

/**
 * A directory that answers from a table that its subclass fills.
 *
 * <p>Threads: daemons {@code dfra-directory-n}, one for each listener that is being notified; they
 * end after {@link #close}. In lock-step the scheduler notifies the listeners.
 */
public abstract class CachedModuleDirectory implements ModuleDirectory {

  private static final AtomicInteger THREADS = new AtomicInteger();

  /** The best first; see {@link ModuleDirectory#find}. */
  static final Comparator<ModuleListing<?>> BEST_FIRST =
      Comparator.<ModuleListing<?>, Boolean>comparing(CachedModuleDirectory::isFailedOrStopped)
          .thenComparing(ModuleListing::locality)
          .thenComparing(ModuleListing::stale)
          .thenComparing(ModuleListing::robot)
          .thenComparing(ModuleListing::name)
          .thenComparing(ModuleListing::id);

  private final ModuleTable table;
  private final ExecutorService threads =
      Executors.newCachedThreadPool(
          task -> {
            Thread thread = new Thread(task, "dfra-directory-" + THREADS.incrementAndGet());
            thread.setDaemon(true);
            return thread;
          });
  private final ReentrantLock lock = new ReentrantLock();
  private final Condition changed;
  private final Executor notifiers;
  private final Scheduler scheduler;

  @GuardedBy("lock")
  private final List<ListenerNotifier<?>> feeds = new ArrayList<>();

  @GuardedBy("lock")
  private boolean closed;

  /**
   * @param clock the clock by which staleness is measured
   */
  protected CachedModuleDirectory(InstantSource clock) {
    this(clock, Scheduler.system());
  }

  /**
   * @param clock the clock by which staleness is measured
   * @param scheduler the scheduler for timeouts
   */
  protected CachedModuleDirectory(InstantSource clock, Scheduler scheduler) {
    this.table = new ModuleTable(clock);
    this.scheduler = scheduler;
    this.changed = scheduler.newCondition(lock);
    this.notifiers = scheduler.isLockStep() ? task -> scheduler.after(0, task) : threads;
    table.addObserver(id -> signal());
  }

  /** The table of this directory, to be filled by the subclass. */
  protected final ModuleTable table() {
    return table;
  }

  static boolean isFailedOrStopped(ModuleListing<?> listing) {
    return listing
        .attributes(ModuleAttributes.class)
        .filter(module -> module.state().isFailedOrStopped())
        .isPresent();
  }

  @Override
  public final <M extends Module> List<ModuleListing<M>> find(ModuleQuery<M> query) {
    List<ModuleListing<M>> found = new ArrayList<>();
    for (ModuleListing<Module> each : table.all()) {
      if (query.matches(each, table::robotPosition)) {
        found.add(as(each));
      }
    }
    return found; // in the table's order
  }

  private <M extends Module> Optional<ModuleListing<M>> best(ModuleQuery<M> query) {
    for (ModuleListing<Module> each : table.all()) {
      if (query.matches(each, table::robotPosition)) {
        return Optional.of(as(each));
      }
    }
    return Optional.empty();
  }

  @SuppressWarnings("unchecked") // the query has checked its type, and a listing is immutable
  private static <M extends Module> ModuleListing<M> as(ModuleListing<Module> listing) {
    return (ModuleListing<M>) listing;
  }

  @Override
  public final <M extends Module> Optional<ModuleListing<M>> findFirst(
      ModuleQuery<M> query, Duration patience) throws InterruptedException {
    long nanos = TimeUnit.NANOSECONDS.convert(patience);
    lock.lock();
    try {
      while (true) {
        Optional<ModuleListing<M>> best = best(query);
        if (best.isPresent() || nanos <= 0 || closed) {
          return best;
        }
        nanos = changed.awaitNanos(nanos);
      }
    } finally {
      lock.unlock();
    }
  }

  private void signal() {
    lock.lock();
    try {
      changed.signalAll();
    } finally {
      lock.unlock();
    }
  }

  @Override
  public final <M extends Module> DirectoryRegistration listen(
      ModuleQuery<M> query, DirectoryListener<M> listener) {
    ListenerNotifier<M> feed =
        new ListenerNotifier<>(
            id -> look(id, query), listener, notifiers, scheduler, this::dismiss);
    lock.lock();
    try {
      if (closed) {
        throw new IllegalStateException("this directory is closed; listen to another one");
      }
      feeds.add(feed);
    } finally {
      lock.unlock();
    }
    table.addObserver(feed);
    table.all().forEach(each -> feed.accept(each.id()));
    return feed;
  }

  private <M extends Module> @Nullable ModuleListing<M> look(UUID id, ModuleQuery<M> query) {
    @Nullable ModuleListing<Module> now = table.get(id);
    return now != null && query.matches(now, table::robotPosition) ? as(now) : null;
  }

  private void dismiss(ListenerNotifier<?> feed) {
    table.removeObserver(feed);
    lock.lock();
    try {
      feeds.remove(feed);
    } finally {
      lock.unlock();
    }
  }

  @Override
  public final List<Persona> personas() {
    return PersonaGrouper.of(table.robots(), table.all());
  }

  @Override
  public final <M extends Module> M proxyFor(ModuleQuery<M> query) {
    Class<M> kind = query.kind();
    return kind.cast(
        Proxy.newProxyInstance(
            kind.getClassLoader(),
            new Class<?>[] {kind},
            new FailoverHandler<>(query, remembered(query), scheduler::nanos)));
  }

  /** The result of a query; re-evaluated only when the table has changed. */
  private <M extends Module> Supplier<List<ModuleListing<M>>> remembered(ModuleQuery<M> query) {
    return new Supplier<>() {
      @GuardedBy("this")
      private long version = -1;

      @GuardedBy("this")
      private List<ModuleListing<M>> found = List.of();

      @Override
      public synchronized List<ModuleListing<M>> get() {
        long now = table.version();
        if (version != now) {
          found = find(query);
          version = now;
        }
        return found;
      }
    };
  }

  /** {@inheritDoc} A subclass closes its own resources first. */
  @Override
  public void close() {
    List<ListenerNotifier<?>> ending;
    lock.lock();
    try {
      closed = true;
      ending = List.copyOf(feeds);
      changed.signalAll();
    } finally {
      lock.unlock();
    }
    ending.forEach(ListenerNotifier::close);
    threads.shutdown();
    table.clear();
  }
}
