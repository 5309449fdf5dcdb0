package org.dfra.core.budget;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.LongSupplier;
import org.dfra.core.budget.Budget.Scope;
import org.dfra.security.Caller;
import org.dfra.security.Guard.Measurement;
import org.dfra.security.Member;
import org.jspecify.annotations.Nullable;

/**
 * The accounts of all budgets of one policy in one process. Thread-safe.
 *
 * <p>Its memory is bounded: beyond {@value #MAX_ACCOUNTS} accounts, the further callers and objects
 * of a budget share one.
 */
final class BudgetAccounts {

  static final int MAX_ACCOUNTS = 512;

  private static final int MAX_KNOWN = 10_000;
  private static final String SHARED = "(others)";

  private final Budgets declared;
  private final List<Budget> own;
  private final LongSupplier nanos;
  private final Measurement measurement;
  private final ConcurrentHashMap<Subject, BudgetAccount[]> known = new ConcurrentHashMap<>();

  @GuardedBy("this")
  private final Map<AccountKey, BudgetAccount> accounts = new HashMap<>();

  /** What the accounts of a call depend on. */
  private record Subject(
      Caller.Standing standing, @Nullable Member member, String address, String object) {

    /** Faster than that of a record, above all with the first compiler alone. */
    @Override
    public int hashCode() {
      int hash = member == null ? address.hashCode() : member.name().hashCode();
      return 31 * (31 * hash + object.hashCode()) + standing.ordinal();
    }

    @Override
    public boolean equals(@Nullable Object other) {
      return other instanceof Subject subject
          && standing == subject.standing
          && object.equals(subject.object)
          && address.equals(subject.address)
          && (member == null ? subject.member == null : isSame(member, subject.member));
    }

    private static boolean isSame(Member one, @Nullable Member other) {
      return one == other
          || (other != null
              && one.role() == other.role()
              && one.name().equals(other.name())
              && one.team().equals(other.team()));
    }
  }

  private record AccountKey(String budget, String owner) {}

  /**
   * @param robot name of this process's robot
   * @param nanos a monotonic clock in nanoseconds
   */
  BudgetAccounts(Budgets declared, String robot, LongSupplier nanos) {
    this.declared = declared;
    this.own = declared.all().stream().filter(each -> each.robots().test(robot)).toList();
    this.nanos = nanos;
    this.measurement =
        own.isEmpty()
            ? Measurement.NONE
            : own.stream().anyMatch(each -> each.limits().processorTime() < BudgetLimits.UNLIMITED)
                ? Measurement.BYTES_AND_PROCESSOR_TIME
                : Measurement.BYTES;
  }

  Budgets declared() {
    return declared;
  }

  /** What must be known of each call. */
  Measurement measurement() {
    return measurement;
  }

  long now() {
    return nanos.getAsLong();
  }

  /** The accounts that calls of a caller to an object use. */
  BudgetAccount[] accounts(Caller caller, String object) {
    @Nullable Member member = caller.member().orElse(null);
    Subject subject =
        new Subject(caller.standing(), member, member == null ? caller.address() : "", object);
    BudgetAccount @Nullable [] found = known.get(subject);
    if (found != null) {
      return found;
    }
    if (known.size() >= MAX_KNOWN) {
      known.clear();
    }
    BudgetAccount[] opened = open(caller, object);
    known.put(subject, opened);
    return opened;
  }

  private synchronized BudgetAccount[] open(Caller caller, String object) {
    List<BudgetAccount> opened = new ArrayList<>();
    for (Budget each : own) {
      boolean hasOwner = each.scope() == Scope.CALLER || !object.isEmpty();
      if (hasOwner && each.callers().test(caller) && each.objects().test(object)) {
        opened.add(account(each, each.scope() == Scope.CALLER ? name(caller) : object));
      }
    }
    return opened.toArray(BudgetAccount[]::new);
  }

  /** How a caller is named: a member without its team, which is the robot's. */
  static String name(Caller caller) {
    return caller
        .member()
        .map(member -> member.role().text() + " " + member.name())
        .orElseGet(() -> "stranger " + caller.address());
  }

  @GuardedBy("this")
  private BudgetAccount account(Budget budget, String owner) {
    AccountKey key = new AccountKey(budget.name(), owner);
    BudgetAccount found = accounts.get(key);
    if (found != null) {
      return found;
    }
    if (accounts.size() >= MAX_ACCOUNTS) {
      accounts.values().removeIf(each -> each.isIdle(now()));
      known.clear(); // it may name removed ones
    }
    String named = accounts.size() >= MAX_ACCOUNTS ? SHARED : owner;
    return accounts.computeIfAbsent(
        new AccountKey(budget.name(), named), key2 -> new BudgetAccount(budget, named, now()));
  }

  /** All accounts. */
  synchronized List<BudgetAccount> all() {
    return List.copyOf(accounts.values());
  }
}
