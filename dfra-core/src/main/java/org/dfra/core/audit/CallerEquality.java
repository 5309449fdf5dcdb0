package org.dfra.core.audit;

import java.util.Optional;
import org.dfra.security.Caller;
import org.dfra.security.Member;

/**
 * Compares callers as their records do, but field by field: a record's own method takes 600 ns with
 * the first compiler only (C1), which is what robots' groups have, and this one 30 ns.
 */
final class CallerEquality {

  private CallerEquality() {}

  static boolean areEqual(Caller one, Caller two) {
    return one.standing() == two.standing()
        && one.address().equals(two.address())
        && areEqual(one.member(), two.member());
  }

  private static boolean areEqual(Optional<Member> one, Optional<Member> two) {
    if (one.isEmpty() || two.isEmpty()) {
      return one.isEmpty() && two.isEmpty();
    }
    Member first = one.get();
    Member second = two.get();
    return first.role() == second.role()
        && first.name().equals(second.name())
        && first.team().equals(second.team());
  }
}
