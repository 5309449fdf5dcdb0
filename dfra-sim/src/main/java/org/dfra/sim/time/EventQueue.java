package org.dfra.sim.time;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import java.util.TreeSet;
import java.util.concurrent.locks.ReentrantLock;
import org.jspecify.annotations.Nullable;

/**
 * The current time and the scheduled events, ordered by time, then by the sequence number given on
 * entry. Thread-safe.
 */
final class EventQueue {

  /** A time that is never reached. */
  static final long NEVER = Long.MAX_VALUE;

  /** More events than this at one instant indicate an endless loop. */
  private static final long MOST_AT_ONCE = 1_000_000;

  /**
   * A scheduled event.
   *
   * @param at when, nanoseconds of this time
   * @param sequence its order among events of the same time
   * @param description of the event; its {@code toString} is for people
   * @param action executed at that time
   */
  record ScheduledEvent(long at, long sequence, Object description, Runnable action)
      implements Comparable<ScheduledEvent> {

    @Override
    public int compareTo(ScheduledEvent other) {
      return at != other.at ? Long.compare(at, other.at) : Long.compare(sequence, other.sequence);
    }
  }

  /** Guards this queue and the scheduling of all stepped threads. */
  final ReentrantLock lock = new ReentrantLock();

  @GuardedBy("lock")
  private final TreeSet<ScheduledEvent> due = new TreeSet<>();

  @GuardedBy("lock")
  private long numbers;

  @GuardedBy("lock")
  private long atThisInstant;

  private volatile long now; // written under lock

  /** Nanoseconds since the beginning. */
  long now() {
    return now;
  }

  /** The time after this delay; {@link #NEVER} on overflow. */
  long timeAfter(long nanos) {
    long wait = Math.max(0, nanos);
    return NEVER - now <= wait ? NEVER : now + wait;
  }

  /** Adds an event, not earlier than now. */
  ScheduledEvent add(long at, Object what, Runnable action) {
    lock.lock();
    try {
      return enter(new ScheduledEvent(Math.max(at, now), numbers++, what, action));
    } finally {
      lock.unlock();
    }
  }

  /** Adds an event again with its previous sequence number. */
  ScheduledEvent reschedule(ScheduledEvent last, long at) {
    lock.lock();
    try {
      return enter(new ScheduledEvent(at, last.sequence(), last.description(), last.action()));
    } finally {
      lock.unlock();
    }
  }

  @GuardedBy("lock")
  private ScheduledEvent enter(ScheduledEvent entry) {
    due.add(entry);
    return entry;
  }

  /** Cancels an event that has not happened yet. */
  void remove(ScheduledEvent entry) {
    lock.lock();
    try {
      due.remove(entry);
    } finally {
      lock.unlock();
    }
  }

  /**
   * Removes the first event due by {@code until} and advances the time to it; where there is none,
   * advances the time to {@code until} and returns null.
   *
   * @throws IllegalStateException if so many events occur at one instant that time does not
   *     advance, or there is no event and {@code until} is {@link #NEVER}
   */
  @Nullable ScheduledEvent next(long until) {
    lock.lock();
    try {
      if (due.isEmpty() || due.first().at() > until) {
        if (until == NEVER) {
          throw new IllegalStateException(
              "this wait would never end: it has no timeout, and no event is scheduled");
        }
        now = Math.max(now, until);
        atThisInstant = 0;
        return null;
      }
      ScheduledEvent first = due.first();
      due.remove(first);
      atThisInstant = first.at() == now ? atThisInstant + 1 : 1;
      now = first.at();
      if (atThisInstant > MOST_AT_ONCE) {
        throw new IllegalStateException(
            "simulated time does not advance: more than "
                + MOST_AT_ONCE
                + " events have run at one instant, now "
                + first.description()
                + "; let it wait before it repeats");
      }
      return first;
    } finally {
      lock.unlock();
    }
  }
}
