package org.dfra.core.directory;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import java.time.Duration;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.UUID;
import java.util.concurrent.Executor;
import java.util.function.Consumer;
import java.util.function.Function;
import org.dfra.directory.DirectoryListener;
import org.dfra.directory.DirectoryRegistration;
import org.dfra.directory.ModuleListing;
import org.dfra.module.Module;
import org.dfra.time.Scheduler;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Notifies one listener of changes. It queues the identities of changed modules, not the changes,
 * and compares the listings when the listener is ready: so the queue of a slow listener contains at
 * most one identity per module.
 */
final class ListenerNotifier<M extends Module> implements DirectoryRegistration, Consumer<UUID> {

  private static final Logger LOG = LoggerFactory.getLogger(ListenerNotifier.class);

  /** Delay before the next attempt to start a thread after one has failed. */
  static final Duration RETRY = Duration.ofMillis(200);

  private final Function<UUID, @Nullable ModuleListing<M>> look;
  private final DirectoryListener<M> listener;
  private final Executor threads;
  private final Scheduler scheduler;
  private final Runnable onClose;
  private final Map<UUID, ModuleListing<M>> notified =
      new HashMap<>(); // used by the draining thread only

  @GuardedBy("this")
  private final Set<UUID> waiting = new LinkedHashSet<>();

  @GuardedBy("this")
  private boolean draining;

  @GuardedBy("this")
  private boolean closed;

  /**
   * @param look returns the current listing of a matching module, or null
   * @param threads notifies the listener
   * @param scheduler schedules retries when {@code threads} refuses a task
   */
  ListenerNotifier(
      Function<UUID, @Nullable ModuleListing<M>> look,
      DirectoryListener<M> listener,
      Executor threads,
      Scheduler scheduler,
      Consumer<ListenerNotifier<M>> onClose) {
    this.look = look;
    this.listener = listener;
    this.threads = threads;
    this.scheduler = scheduler;
    this.onClose = () -> onClose.accept(this);
  }

  @Override
  public void accept(UUID id) {
    synchronized (this) {
      if (closed) {
        return;
      }
      waiting.add(id);
      if (draining) {
        return;
      }
      draining = true;
    }
    begin();
  }

  /** Starts a thread that drains the queue; if none can be started, retries after a delay. */
  private void begin() {
    try {
      threads.execute(this::drain);
    } catch (RuntimeException | Error e) {
      LOG.warn(
          "A directory listener cannot be notified now ({}); it is tried again every {} ms.",
          e.toString(),
          RETRY.toMillis());
      Scheduler.ScheduledTask unused = scheduler.after(RETRY.toNanos(), this::begin);
    }
  }

  private void drain() {
    while (true) {
      List<UUID> batch;
      synchronized (this) {
        if (closed || waiting.isEmpty()) {
          draining = false;
          return;
        }
        batch = List.copyOf(waiting);
        waiting.clear();
      }
      batch.forEach(this::compare);
    }
  }

  private void compare(UUID id) {
    @Nullable ModuleListing<M> now = look.apply(id);
    @Nullable ModuleListing<M> before = now == null ? notified.remove(id) : notified.put(id, now);
    synchronized (this) {
      if (closed) {
        return;
      }
    }
    try {
      if (before == null && now != null) {
        listener.matched(now);
      } else if (before != null && now == null) {
        listener.unmatched(before);
      } else if (before != null && now != null && before != now) {
        listener.changed(before, now);
      }
    } catch (RuntimeException | Error e) { // the next change must reach it nevertheless
      LOG.warn("A directory listener failed: {}", e.toString(), e);
    }
  }

  @Override
  public void close() {
    synchronized (this) {
      closed = true;
      waiting.clear();
    }
    onClose.run();
  }
}
