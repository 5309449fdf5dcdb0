package org.dfra.core.budget;

import java.util.concurrent.TimeUnit;

/**
 * What was used of one resource, and how much of it is free: a token bucket that fills at the
 * limit's rate, up to what one second brings. What is known only afterwards, such as bytes, may
 * overdraw it, by as much as {@value #DEBT_SECONDS} s bring. Not thread-safe: its account has a
 * lock.
 */
final class RateMeter {

  /** How long nothing is free after any overdraft, at most. */
  static final int DEBT_SECONDS = 10;

  /** The time over which use is averaged, in seconds. */
  static final int WINDOW_SECONDS = 10;

  private static final double NANOS = TimeUnit.SECONDS.toNanos(1);

  private final double limit;
  private final double capacity;
  private double free;
  private long filled;
  private final double[] cells = new double[WINDOW_SECONDS + 1]; // one for each second
  private final long born;
  private long second; // since then

  /**
   * @param limit per second; may be infinite
   * @param least the capacity at least, such as one call
   */
  RateMeter(double limit, double least, long now) {
    this.limit = limit;
    this.capacity = Math.max(limit, least);
    this.free = capacity;
    this.filled = now;
    this.born = now;
  }

  /** Until an amount is free, in nanoseconds; 0 if it is now. */
  long nanosUntil(double amount, long now) {
    if (limit == BudgetLimits.UNLIMITED) {
      return 0;
    }
    fill(now);
    return free >= amount ? 0 : (long) Math.ceil((amount - free) / limit * NANOS);
  }

  private void fill(long now) {
    free = Math.min(capacity, free + limit * Math.max(0, now - filled) / NANOS);
    filled = now;
  }

  /** Uses an amount, also if it is not free. */
  void use(double amount, long now) {
    if (limit != BudgetLimits.UNLIMITED) {
      fill(now);
      free = Math.max(-limit * DEBT_SECONDS, free - amount);
    }
    cells[cell(now)] += amount;
  }

  /** Undoes {@link #use}. */
  void giveBack(double amount, long now) {
    if (limit != BudgetLimits.UNLIMITED) {
      fill(now);
      free = Math.min(capacity, free + amount);
    }
    int cell = cell(now);
    cells[cell] = Math.max(0, cells[cell] - amount);
  }

  /** The mean use per second over the last full {@value #WINDOW_SECONDS} s. */
  double mean(long now) {
    int current = cell(now);
    double sum = 0;
    for (int i = 0; i < cells.length; i++) {
      sum += i == current ? 0 : cells[i];
    }
    return sum / WINDOW_SECONDS;
  }

  /** Whether nothing was used lately, and all is free. */
  boolean isIdle(long now) {
    return mean(now) == 0 && cells[cell(now)] == 0 && nanosUntil(capacity, now) == 0;
  }

  /** The cell of a time, after the cells of the seconds without use are emptied. */
  private int cell(long now) {
    long current = (long) ((now - born) / NANOS);
    for (long each = Math.max(second + 1, current - cells.length + 1); each <= current; each++) {
      cells[(int) (each % cells.length)] = 0;
    }
    second = Math.max(second, current);
    return (int) (second % cells.length);
  }
}
