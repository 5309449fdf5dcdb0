package org.dfra.core.chain;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import java.rmi.RemoteException;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.UUID;
import java.util.function.Supplier;
import org.dfra.directory.DirectoryListener;
import org.dfra.directory.DirectoryRegistration;
import org.dfra.directory.ModuleDirectory;
import org.dfra.directory.ModuleListing;
import org.dfra.directory.ModuleQuery;
import org.dfra.event.Delivery;
import org.dfra.event.DeliveryPolicy;
import org.dfra.event.DeliveryPolicy.EventKind;
import org.dfra.event.ModuleEvent;
import org.dfra.event.Reading;
import org.dfra.event.Subscription;
import org.dfra.module.Module;
import org.dfra.time.Scheduler;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;

/**
 * The inputs of one module in a chain. Each input subscribes to modules of its type, mostly of its
 * own robot, as they come and go: to all of them, or to one, the first found, until it disappears.
 * Or it subscribes to the module that it is wired to. Rewiring ends the old subscriptions once the
 * new ones are known to be possible; otherwise the old ones stay.
 */
public final class ChainInputs implements AutoCloseable {

  /** Readings queued for a slow module; older ones are dropped. */
  private static final int DEPTH = 64;

  private static final long RETRY_NANOS = 1_000_000_000;

  /**
   * Consumes readings.
   *
   * @param <R> the type of readings
   */
  @FunctionalInterface
  public interface ReadingConsumer<R extends Reading> {

    /**
     * Consumes a reading; on a delivery thread, one at a time for each module.
     *
     * @param source the module that published it, as listed when it was found
     */
    void accept(ModuleListing<?> source, R reading);
  }

  /**
   * Consumes readings with their sequence numbers, by which it detects losses.
   *
   * @param <R> the type of readings
   */
  @FunctionalInterface
  public interface SequencedReadingConsumer<R extends Reading> {

    /**
     * As {@link ReadingConsumer#accept}.
     *
     * @param sequence see {@link Delivery#sequence}
     */
    void accept(ModuleListing<?> source, long sequence, R reading);
  }

  /** The declaration of one input. */
  record InputDeclaration<M extends Module, R extends Reading>(
      ModuleQuery<M> query,
      boolean isMany,
      String origin,
      Class<R> type,
      SequencedReadingConsumer<? super R> consumer) {}

  private final String module;
  private final Supplier<ModuleDirectory> directory;
  private final SubscriptionExecutor subscriber;
  private final Logger log;
  private final List<InputDeclaration<?, ?>> inputs = new ArrayList<>();
  private volatile List<Feed<?, ?>> feeds = List.of(); // written with the lock of this held

  @GuardedBy("this")
  private boolean closed;

  /**
   * @param module the module of these inputs, {@code robot/name}
   * @param directory finds the modules
   * @param scheduler for retries of subscriptions to modules that could not be reached
   */
  public ChainInputs(
      String module, Supplier<ModuleDirectory> directory, Scheduler scheduler, Logger log) {
    this.module = module;
    this.directory = directory;
    this.subscriber = new SubscriptionExecutor(scheduler);
    this.log = log;
  }

  /**
   * Declares the next input, one of the modules that qualify; before any is wired.
   *
   * @param query the modules that qualify
   * @param origin states where the module is named, to complete a clause that it is missing; or
   *     empty
   * @param type the type of readings that it consumes
   */
  public <M extends Module, R extends Reading> void declareOne(
      ModuleQuery<M> query,
      String origin,
      Class<R> type,
      SequencedReadingConsumer<? super R> consumer) {
    inputs.add(new InputDeclaration<>(query, false, origin, type, consumer));
  }

  /** The same with all modules that qualify. */
  public <M extends Module, R extends Reading> void declareAll(
      ModuleQuery<M> query, Class<R> type, SequencedReadingConsumer<? super R> consumer) {
    inputs.add(new InputDeclaration<>(query, true, "", type, consumer));
  }

  /** The types of the inputs, by the simple names of their classes. */
  public List<String> types() {
    return inputs.stream().map(input -> input.type().getSimpleName()).toList();
  }

  /** The missing inputs, as a clause; empty if each input has a module. */
  public Optional<String> missing() {
    return feeds.stream()
        .filter(Feed::isAlone)
        .findFirst()
        .map(feed -> "there is no " + feed.wanted + feed.input.origin());
  }

  /**
   * Replaces the input modules.
   *
   * @param paths one for each input, {@code robot/name}; empty to let each input find its own
   * @throws IllegalArgumentException if one is not available, or not of the input's type
   */
  public synchronized void wire(List<String> paths) {
    if (closed) {
      return;
    }
    List<ModuleQuery<?>> queries = new ArrayList<>();
    for (int i = 0; i < inputs.size(); i++) {
      queries.add(paths.isEmpty() ? inputs.get(i).query() : wired(inputs.get(i), paths.get(i)));
    }
    feeds.forEach(Feed::close);
    List<Feed<?, ?>> fresh = new ArrayList<>();
    for (int i = 0; i < inputs.size(); i++) {
      fresh.add(feed(inputs.get(i), queries.get(i)));
    }
    feeds = fresh;
  }

  private <M extends Module> ModuleQuery<M> wired(InputDeclaration<M, ?> input, String path) {
    ModuleQuery<Module> named = ModuleQuery.of(Module.class).robot(robot(path)).name(name(path));
    if (directory.get().find(named).isEmpty()) {
      throw new IllegalArgumentException(
          module + " cannot be wired to " + path + ": there is no such module");
    }
    Class<M> kind = input.query().kind();
    ModuleQuery<M> query = ModuleQuery.of(kind).robot(robot(path)).name(name(path));
    if (directory.get().find(query).isEmpty()) {
      throw new IllegalArgumentException(
          module + " cannot be wired to " + path + ": it is not of type " + kind.getSimpleName());
    }
    return query;
  }

  @SuppressWarnings("unchecked") // the query was made from the input's type
  private <M extends Module, R extends Reading> Feed<M, R> feed(
      InputDeclaration<M, R> input, ModuleQuery<?> query) {
    Feed<M, R> feed = new Feed<>(input, query.toString());
    feed.watch = directory.get().listen((ModuleQuery<M>) query, feed);
    return feed;
  }

  private static String robot(String path) {
    return path.substring(0, path.indexOf('/'));
  }

  private static String name(String path) {
    return path.substring(path.indexOf('/') + 1);
  }

  /** Ends all subscriptions. */
  @Override
  public synchronized void close() {
    closed = true;
    feeds.forEach(Feed::close);
    feeds = List.of();
  }

  /** An active input: a subscription to each module that it has found. */
  private final class Feed<M extends Module, R extends Reading> implements DirectoryListener<M> {

    private final InputDeclaration<M, R> input;
    private final String wanted; // the wanted modules, for messages

    @GuardedBy("this")
    private final Map<UUID, Tie> ties = new HashMap<>();

    /** The further candidates, in order of discovery. */
    @GuardedBy("this")
    private final Map<UUID, ModuleListing<M>> inLine = new LinkedHashMap<>();

    @GuardedBy("this")
    private boolean over;

    private volatile @Nullable DirectoryRegistration watch;

    Feed(InputDeclaration<M, R> input, String wanted) {
      this.input = input;
      this.wanted = wanted;
    }

    synchronized boolean isAlone() {
      return ties.isEmpty();
    }

    @Override
    public void matched(ModuleListing<M> listing) {
      @Nullable Tie tie = tie(listing);
      if (tie != null) {
        tie.beginSoon();
      }
    }

    /** A new subscription; null if the module is only a candidate, or the input is closed. */
    private synchronized @Nullable Tie tie(ModuleListing<M> listing) {
      if (over) {
        return null;
      }
      if (!input.isMany() && !ties.isEmpty()) {
        inLine.put(listing.id(), listing);
        return null;
      }
      Tie tie = new Tie(listing);
      ties.put(listing.id(), tie);
      return tie;
    }

    @Override
    public void changed(ModuleListing<M> before, ModuleListing<M> now) {
      @Nullable Tie tie;
      synchronized (this) {
        inLine.computeIfPresent(now.id(), (id, listed) -> now);
        tie = ties.get(now.id());
      }
      boolean isOther = before.module() != now.module() && !before.module().equals(now.module());
      if (tie != null && (isOther || tie.isDead())) {
        renew(tie, now);
      }
    }

    /** The module has moved, or was restarted in place. */
    private void renew(Tie old, ModuleListing<M> now) {
      Tie fresh = new Tie(now);
      synchronized (this) {
        if (over || !ties.replace(now.id(), old, fresh)) {
          return;
        }
      }
      old.cut();
      subscriber.execute(
          () -> {
            old.close();
            fresh.begin();
          });
    }

    @Override
    public void unmatched(ModuleListing<M> last) {
      @Nullable Tie tie;
      @Nullable Tie heir = null;
      synchronized (this) {
        inLine.remove(last.id());
        tie = ties.remove(last.id());
        if (tie != null && !inLine.isEmpty()) {
          UUID next = inLine.keySet().iterator().next();
          heir = tie(inLine.remove(next));
        }
      }
      if (tie != null) {
        tie.closeSoon();
      }
      if (heir != null) {
        heir.beginSoon();
      }
    }

    void close() {
      @Nullable DirectoryRegistration watching = watch;
      if (watching != null) {
        watching.close();
      }
      List<Tie> ending;
      synchronized (this) {
        over = true;
        ending = List.copyOf(ties.values());
        ties.clear();
      }
      ending.forEach(Tie::close);
    }

    /** A subscription, established or pending. */
    private final class Tie {
      private final ModuleListing<M> source;

      @GuardedBy("this")
      private @Nullable Subscription subscription;

      private volatile boolean cut; // set with the lock of this held

      private boolean isFailureLogged; // of a failure; used by one thread at a time

      Tie(ModuleListing<M> source) {
        this.source = source;
      }

      /** Subscribes without blocking the directory, which reports the other modules meanwhile. */
      void beginSoon() {
        subscriber.execute(this::begin);
      }

      private void begin() {
        synchronized (this) {
          if (cut) {
            return;
          }
        }
        try {
          Subscription made =
              source
                  .module()
                  .subscribe(
                      this::take, DeliveryPolicy.keepLast(DEPTH).withKinds(EventKind.READING));
          synchronized (this) {
            if (!cut) {
              subscription = made;
              return;
            }
          }
          made.close();
        } catch (RemoteException | RuntimeException e) {
          if (!isFailureLogged) {
            isFailureLogged = true;
            log.warn(
                "{}: {} cannot be listened to and is tried again: {}",
                module,
                source.path(),
                e.toString());
          }
          subscriber.schedule(RETRY_NANOS, this::begin);
        }
      }

      /** Whether the subscription has ended. */
      synchronized boolean isDead() {
        return subscription != null && !subscription.isOpen();
      }

      private void take(Delivery delivery) {
        if (!cut
            && delivery.event() instanceof ModuleEvent.NewReading fresh
            && input.type().isInstance(fresh.reading())) {
          input.consumer().accept(source, delivery.sequence(), input.type().cast(fresh.reading()));
        }
      }

      /**
       * Takes no more readings from now on, and tells the module without blocking the directory.
       */
      void closeSoon() {
        cut();
        subscriber.execute(this::close);
      }

      private synchronized void cut() {
        cut = true;
      }

      void close() {
        @Nullable Subscription ending;
        synchronized (this) {
          cut = true;
          ending = subscription;
          subscription = null;
        }
        if (ending != null) {
          ending.close();
        }
      }
    }
  }
}
