package org.dfra.core.budget;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import java.time.Duration;
import java.util.EnumMap;
import java.util.Map;
import org.jspecify.annotations.Nullable;

/** What one caller, or one object, has used of one budget. Thread-safe. */
final class BudgetAccount {

  /** The longest time by which a call is slowed: less than the deadlines of calls. */
  static final Duration LONGEST_WAIT = Duration.ofMillis(500);

  /** So many calls of one account wait at once; beyond, they are refused. */
  static final int MAX_WAITING = 4;

  private final Budget budget;
  private final String owner;

  @GuardedBy("this")
  private final Map<BudgetResource, RateMeter> meters = new EnumMap<>(BudgetResource.class);

  @GuardedBy("this")
  private int waiting;

  @GuardedBy("this")
  private long refused;

  @GuardedBy("this")
  private long slowed;

  @GuardedBy("this")
  private long thinned;

  /**
   * What an account answers to a call.
   *
   * @param used the resource that is used up; null if the call may run at once
   * @param nanos until it is free
   * @param isAdmitted whether the call may run after that time; it is counted already
   */
  record Admission(@Nullable BudgetResource used, long nanos, boolean isAdmitted) {

    static final Admission AT_ONCE = new Admission(null, 0, true);
  }

  BudgetAccount(Budget budget, String owner, long now) {
    this.budget = budget;
    this.owner = owner;
    for (BudgetResource each : BudgetResource.values()) {
      double least = each == BudgetResource.CALLS ? 1 : 0;
      meters.put(each, new RateMeter(budget.limits().of(each), least, now));
    }
  }

  Budget budget() {
    return budget;
  }

  /** Whose account it is, such as {@code observer otto}. */
  String owner() {
    return owner;
  }

  @GuardedBy("this")
  private RateMeter meter(BudgetResource resource) {
    RateMeter found = meters.get(resource);
    if (found == null) {
      throw new IllegalStateException("no meter of " + resource);
    }
    return found;
  }

  /** Counts a call, if it may run now or soon. */
  synchronized Admission admit(long now) {
    @Nullable BudgetResource used = null;
    long longest = 0;
    for (BudgetResource each : BudgetResource.values()) {
      long nanos = meter(each).nanosUntil(each == BudgetResource.CALLS ? 1 : 0, now);
      if (nanos > longest) {
        longest = nanos;
        used = each;
      }
    }
    if (used != null) {
      boolean mayWait =
          budget.isSlowing() && longest <= LONGEST_WAIT.toNanos() && waiting < MAX_WAITING;
      if (!mayWait) {
        return new Admission(used, longest, false);
      }
      waiting++;
    }
    meter(BudgetResource.CALLS).use(1, now);
    return used == null ? Admission.AT_ONCE : new Admission(used, longest, true);
  }

  /** A call that was to wait does so no more. */
  synchronized void waited(boolean isSlowed) {
    waiting--;
    slowed += isSlowed ? 1 : 0;
  }

  /** Counts a call that is never refused. */
  synchronized void use(BudgetResource resource, double amount, long now) {
    meter(resource).use(amount, now);
  }

  /** A call that was counted does not run, since another account refuses it. */
  synchronized void giveBackCall(long now) {
    meter(BudgetResource.CALLS).giveBack(1, now);
  }

  synchronized void countRefused() {
    refused++;
  }

  synchronized void countThinned(long readings) {
    thinned += readings;
  }

  /** Whether its bytes are used up. */
  synchronized boolean isOutOfBytes(long now) {
    return meter(BudgetResource.BYTES).nanosUntil(0, now) > 0;
  }

  synchronized boolean isIdle(long now) {
    return waiting == 0 && meters.values().stream().allMatch(each -> each.isIdle(now));
  }

  /**
   * What was used.
   *
   * @param listeners of the owner
   */
  synchronized BudgetUse use(int listeners, long now) {
    return new BudgetUse(
        budget.name(),
        budget.scope(),
        owner,
        budget.limits(),
        meter(BudgetResource.BYTES).mean(now),
        meter(BudgetResource.CALLS).mean(now),
        meter(BudgetResource.PROCESSOR_TIME).mean(now),
        listeners,
        refused,
        slowed,
        thinned);
  }
}
