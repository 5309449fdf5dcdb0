package org.dfra.core.budget;

import java.util.function.Predicate;
import org.dfra.core.config.SourceLocation;
import org.dfra.security.Caller;

/**
 * What may be used in a second by each caller that it is about, or of each object that it is about.
 *
 * @param name unique among the budgets of a policy
 * @param callers whose calls count
 * @param robots names of the robots in whose processes it counts
 * @param objects names of the called objects; an object without a name has the empty one
 * @param scope who has an account
 * @param limits of each account
 * @param isSlowing whether calls beyond are slowed as long as that is possible, and not refused
 * @param place in the policy
 */
public record Budget(
    String name,
    Predicate<Caller> callers,
    Predicate<String> robots,
    Predicate<String> objects,
    Scope scope,
    BudgetLimits limits,
    boolean isSlowing,
    SourceLocation place) {

  /** Who has an account of a budget. */
  public enum Scope {
    /** Each caller: a member by its role and name, a stranger by its address. */
    CALLER,
    /** Each called object, for all callers together. */
    OBJECT
  }
}
