package org.dfra.core.budget;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import java.util.function.LongConsumer;
import java.util.function.LongSupplier;
import java.util.function.Predicate;
import java.util.function.Supplier;
import org.dfra.core.budget.BudgetAccount.Admission;
import org.dfra.security.AccessRequest;
import org.dfra.security.CallUse;
import org.dfra.security.Caller;
import org.dfra.security.Decision;
import org.dfra.security.ForwardingGuard;
import org.dfra.security.Guard;

/**
 * Refuses or slows the calls that another guard permits and that a budget has no room for. Calls
 * that are never limited, such as emergency stops, are counted and run at once. Thread-safe.
 *
 * <p>Bytes and processor time of a call are known when it has ended, so they count against the
 * calls that follow.
 */
public final class BudgetGuard extends ForwardingGuard {

  private static final double NANOS_PER_SECOND = 1e9;
  private static final long SECOND = TimeUnit.SECONDS.toNanos(1);

  private final Guard guard;
  private final Supplier<Budgets> declared;
  private final String robot;
  private final Predicate<AccessRequest> isNeverLimited;
  private final LongSupplier nanos;
  private final LongConsumer sleeper;
  private volatile BudgetAccounts current;

  @GuardedBy("this")
  private final List<ListenerShare> listeners = new ArrayList<>();

  /** A guard with this process's clock. */
  public BudgetGuard(
      Guard guard,
      Supplier<Budgets> declared,
      String robot,
      Predicate<AccessRequest> isNeverLimited) {
    this(guard, declared, robot, isNeverLimited, System::nanoTime, BudgetGuard::park);
  }

  /**
   * @param guard decides who may call
   * @param declared the budgets that are in force now: the same object as long as they are
   * @param robot name of this process's robot
   * @param isNeverLimited whether a call runs at once whatever its caller has used
   * @param nanos a monotonic clock in nanoseconds
   * @param sleeper waits for so many nanoseconds
   */
  public BudgetGuard(
      Guard guard,
      Supplier<Budgets> declared,
      String robot,
      Predicate<AccessRequest> isNeverLimited,
      LongSupplier nanos,
      LongConsumer sleeper) {
    this.guard = guard;
    this.declared = declared;
    this.robot = robot;
    this.isNeverLimited = isNeverLimited;
    this.nanos = nanos;
    this.sleeper = sleeper;
    this.current = new BudgetAccounts(declared.get(), robot, nanos);
  }

  private static void park(long nanos) {
    long end = System.nanoTime() + nanos;
    long left = nanos;
    while (left > 0 && !Thread.currentThread().isInterrupted()) {
      LockSupport.parkNanos(BudgetGuard.class, left);
      left = end - System.nanoTime();
    }
  }

  /** The accounts of the budgets that are in force; new ones, if they have been replaced. */
  private BudgetAccounts inForce() {
    BudgetAccounts now = current;
    return now.declared() == declared.get() ? now : replaced();
  }

  private synchronized BudgetAccounts replaced() {
    Budgets next = declared.get();
    if (current.declared() != next) {
      current = new BudgetAccounts(next, robot, nanos);
    }
    return current;
  }

  @Override
  public Measurement measurement() {
    return inForce().measurement();
  }

  @Override
  protected Guard guard() {
    return guard;
  }

  @Override
  public Decision decide(AccessRequest request) {
    BudgetAccounts now = inForce();
    return now.measurement() == Measurement.NONE
        ? guard.decide(request)
        : guard.decide(request, permitted -> admitted(permitted, request, now));
  }

  private Decision admitted(Decision decision, AccessRequest request, BudgetAccounts now) {
    BudgetAccount[] accounts = now.accounts(request.caller(), request.object());
    if (accounts.length == 0) {
      return decision;
    }
    long time = now.now();
    if (isNeverLimited.test(request)) {
      for (BudgetAccount each : accounts) {
        each.use(BudgetResource.CALLS, 1, time);
      }
      return decision;
    }
    long wait = 0;
    List<BudgetAccount> slowing = new ArrayList<>(0);
    for (int i = 0; i < accounts.length; i++) {
      Admission answer = accounts[i].admit(time);
      if (!answer.isAdmitted()) {
        slowing.forEach(each -> each.waited(false));
        for (int j = 0; j < i; j++) {
          accounts[j].giveBackCall(time);
        }
        accounts[i].countRefused();
        return refusal(accounts[i], answer);
      }
      if (answer.used() != null) {
        slowing.add(accounts[i]);
        wait = Math.max(wait, answer.nanos());
      }
    }
    if (wait > 0) {
      try {
        sleeper.accept(wait);
      } finally {
        slowing.forEach(each -> each.waited(true));
      }
    }
    return decision;
  }

  /** In whole seconds, so that the audit trail sums equal refusals. */
  private static Decision refusal(BudgetAccount account, Admission answer) {
    Budget budget = account.budget();
    BudgetResource used = answer.used() == null ? BudgetResource.CALLS : answer.used();
    long seconds = (answer.nanos() + SECOND - 1) / SECOND;
    return Decision.deny(
        "budget " + budget.name(),
        account.owner()
            + " has used up the "
            + used.inWords(budget.limits().of(used))
            + " that it allows "
            + (budget.scope() == Budget.Scope.CALLER ? "each caller" : "all callers together")
            + "; call less often, again in "
            + seconds
            + " s at the latest, or ask an operator for a larger budget");
  }

  @Override
  public void ended(AccessRequest request, CallUse use) {
    BudgetAccounts now = inForce();
    long time = now.now();
    for (BudgetAccount each : now.accounts(request.caller(), request.object())) {
      each.use(BudgetResource.BYTES, use.bytes(), time);
      each.use(BudgetResource.PROCESSOR_TIME, use.processorNanos() / NANOS_PER_SECOND, time);
    }
  }

  /**
   * Admits a remote listener.
   *
   * @param caller who registers it
   * @param object the module that it listens to
   * @throws BudgetExceededException if the caller, or the object, has as many as a budget allows
   */
  public synchronized ListenerShare admitListener(Caller caller, String object)
      throws BudgetExceededException {
    BudgetAccounts now = inForce();
    for (BudgetAccount each : now.accounts(caller, object)) {
      double most = each.budget().limits().listeners();
      int held = listenersOf(each, now);
      if (held >= most && caller.standing() != Caller.Standing.OWN) {
        each.countRefused();
        throw new BudgetExceededException(
            "%s has %d of at most %d listeners of budget %s; close some of them first, or ask an operator for a larger budget"
                .formatted(each.owner(), held, (long) most, each.budget().name()));
      }
    }
    ListenerShare share = new ListenerShare(this, caller, object);
    listeners.add(share);
    return share;
  }

  synchronized void forget(ListenerShare share) {
    listeners.removeIf(each -> each == share);
  }

  @GuardedBy("this")
  private int listenersOf(BudgetAccount account, BudgetAccounts now) {
    int count = 0;
    for (ListenerShare each : listeners) {
      for (BudgetAccount its : now.accounts(each.caller(), each.object())) {
        count += its == account ? 1 : 0;
      }
    }
    return count;
  }

  /** Whether a budget has no room for the bytes of a listener's readings. */
  boolean isOutOfBytes(ListenerShare share) {
    BudgetAccounts now = inForce();
    if (now.measurement() == Measurement.NONE || share.caller().standing() == Caller.Standing.OWN) {
      return false;
    }
    for (BudgetAccount each : now.accounts(share.caller(), share.object())) {
      if (each.isOutOfBytes(now.now())) {
        return true;
      }
    }
    return false;
  }

  /** Counts what was sent to a listener, and what was not. */
  void count(ListenerShare share, long bytes, long thinned) {
    BudgetAccounts now = inForce();
    if (now.measurement() == Measurement.NONE) {
      return;
    }
    for (BudgetAccount each : now.accounts(share.caller(), share.object())) {
      each.use(BudgetResource.BYTES, bytes, now.now());
      each.countThinned(thinned);
    }
  }

  /** Whether anything must be counted. */
  boolean isCounting() {
    return inForce().measurement() != Measurement.NONE;
  }

  /** What all accounts have used, those of a budget together. */
  public synchronized List<BudgetUse> use() {
    BudgetAccounts now = inForce();
    Map<BudgetAccount, Integer> held = new IdentityHashMap<>();
    for (BudgetAccount each : now.all()) {
      held.put(each, listenersOf(each, now));
    }
    return held.entrySet().stream()
        .map(each -> each.getKey().use(each.getValue(), now.now()))
        .sorted(Comparator.comparing(BudgetUse::budget).thenComparing(BudgetUse::owner))
        .toList();
  }

  /** What the network of this robot carries, in bytes per second; empty if nothing is declared. */
  public Optional<Double> radio() {
    return declared.get().radio(robot);
  }
}
