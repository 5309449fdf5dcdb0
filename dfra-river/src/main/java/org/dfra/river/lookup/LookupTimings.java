package org.dfra.river.lookup;

import com.sun.jini.thread.WakeupManager;
import com.sun.jini.thread.WakeupManager.ThreadDesc;
import java.time.Duration;
import java.util.HashMap;
import java.util.Map;
import net.jini.config.Configuration;
import org.dfra.time.Scheduler;
import org.jspecify.annotations.Nullable;

/**
 * The timing of the discovery of lookup services and of the renewal of registrations.
 *
 * <p>River's default retry delays suit an office network: they increase up to a quarter of an hour,
 * and an attempt waits a minute for a peer that stops answering. A robot that returns into radio
 * range must be found within seconds.
 */
final class LookupTimings {

  /** The longest lease that a module requests; a lookup service may grant a shorter one. */
  static final Duration MAX_LEASE = Duration.ofSeconds(30);

  /** The longest delay between two attempts. */
  static final Duration MAX_RETRY_DELAY = Duration.ofSeconds(2);

  /** The timeout of one attempt for its connection, and again for the whole answer. */
  static final Duration ATTEMPT_TIMEOUT = Duration.ofSeconds(2);

  private LookupTimings() {}

  /** Returns the entries of {@code own}, and these timings as defaults. */
  static Configuration configuration(Configuration own) {
    return new SuppliedConfiguration(
        own,
        Map.of(
            "net.jini.lookup.JoinManager.wakeupManager",
            () -> new BoundedWakeupManager(Scheduler.system()),
            "net.jini.lookup.JoinManager.maxLeaseDuration",
            MAX_LEASE::toMillis));
  }

  /**
   * Wakes every task within {@link #MAX_RETRY_DELAY}. Its callers use the wall clock, but the wait
   * itself is monotonic: if the clock is set back, no task waits longer.
   */
  static final class BoundedWakeupManager extends WakeupManager {

    private final Scheduler time;
    private final Map<Ticket, Scheduler.ScheduledTask> pending =
        new HashMap<>(); // guarded by itself

    BoundedWakeupManager(Scheduler time) {
      super(new ThreadDesc(null, true));
      this.time = time;
    }

    @Override
    public Ticket schedule(long when, Runnable task) {
      return schedule(when, task, null);
    }

    /**
     * {@inheritDoc} River's tasks for it only delegate work, so they need no thread of their own.
     */
    @Override
    public Ticket schedule(long when, Runnable task, @Nullable ThreadDesc thread) {
      long millis = Math.min(when - System.currentTimeMillis(), MAX_RETRY_DELAY.toMillis());
      synchronized (pending) {
        Ticket ticket = newTicket(when, task, thread);
        pending.put(ticket, time.after(millis * 1_000_000, () -> run(ticket)));
        return ticket;
      }
    }

    private void run(Ticket ticket) {
      synchronized (pending) {
        if (pending.remove(ticket) == null) {
          return; // cancelled
        }
      }
      ticket.task.run();
    }

    @Override
    public void cancel(Ticket ticket) {
      synchronized (pending) {
        Scheduler.ScheduledTask task = pending.remove(ticket);
        if (task != null) {
          task.cancel();
        }
      }
    }

    @Override
    public void cancelAll() {
      synchronized (pending) {
        pending.values().forEach(Scheduler.ScheduledTask::cancel);
        pending.clear();
      }
    }

    @Override
    public boolean isEmpty() {
      synchronized (pending) {
        return pending.isEmpty();
      }
    }

    @Override
    public void stop() {
      cancelAll();
      super.stop();
    }
  }
}
