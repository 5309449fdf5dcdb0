package org.dfra.sim.time;

import java.util.TreeSet;
import java.util.concurrent.locks.ReentrantLock;
import org.jspecify.annotations.Nullable;

/**
 * What time it is and what will happen, in order: by time; at the same time by number, which is
 * given when something enters. Safe for use by several threads.
 */
final class EventQueue {

  /** A time that does not come. */
  static final long NEVER = Long.MAX_VALUE;

  /** More than this at one instant is no simulation but a circle. */
  private static final long MOST_AT_ONCE = 1_000_000;

  /**
   * Something that will happen.
   *
   * @param at when, nanoseconds of this time
   * @param sequence its place among those of the same time
   * @param description what it is; its {@code toString} is for people
   * @param action what is done then
   */
  record ScheduledEvent(long at, long sequence, Object description, Runnable action)
      implements Comparable<ScheduledEvent> {

    @Override
    public int compareTo(ScheduledEvent other) {
      return at != other.at ? Long.compare(at, other.at) : Long.compare(sequence, other.sequence);
    }
  }

  /** Guards this agenda and all turns. */
  final ReentrantLock lock = new ReentrantLock();

  private final TreeSet<ScheduledEvent> due = new TreeSet<>(); // guarded by lock
  private long numbers; // guarded by lock
  private long atThisInstant; // guarded by lock
  private volatile long now; // written under lock

  /** Nanoseconds since the beginning. */
  long now() {
    return now;
  }

  /** The time so long from now; {@link #NEVER} where that is beyond all times. */
  long timeAfter(long nanos) {
    long wait = Math.max(0, nanos);
    return NEVER - now <= wait ? NEVER : now + wait;
  }

  /** Enters something, at the earliest for now. */
  ScheduledEvent add(long at, Object what, Runnable action) {
    lock.lock();
    try {
      return enter(new ScheduledEvent(Math.max(at, now), numbers++, what, action));
    } finally {
      lock.unlock();
    }
  }

  /** Enters something again, under the number it had. */
  ScheduledEvent reschedule(ScheduledEvent last, long at) {
    lock.lock();
    try {
      return enter(new ScheduledEvent(at, last.sequence(), last.description(), last.action()));
    } finally {
      lock.unlock();
    }
  }

  private ScheduledEvent enter(ScheduledEvent entry) {
    due.add(entry);
    return entry;
  }

  /** It will not happen, if it has not yet. */
  void remove(ScheduledEvent entry) {
    lock.lock();
    try {
      due.remove(entry);
    } finally {
      lock.unlock();
    }
  }

  /**
   * Takes the first that is due by then, and moves the time to it; where there is none, moves the
   * time to then and returns null.
   *
   * @throws IllegalStateException if so much happens at one instant that time does not go on, or
   *     there is nothing and {@code until} never comes
   */
  @Nullable ScheduledEvent next(long until) {
    lock.lock();
    try {
      if (due.isEmpty() || due.first().at() > until) {
        if (until == NEVER) {
          throw new IllegalStateException("nothing will ever happen that this wait could end by");
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
            "time stands still: more than "
                + MOST_AT_ONCE
                + " things have happened at one instant, now again "
                + first.description()
                + "; let it wait a while before it comes again");
      }
      return first;
    } finally {
      lock.unlock();
    }
  }
}
