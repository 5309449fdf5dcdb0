package org.dfra.core.audit;

import java.util.Optional;
import org.dfra.security.Caller;
import org.dfra.security.Member;

/**
 * Compares callers as their records do, but field by field. With the first compiler only (C1),
 * which robots' groups have, a call whose caller is equal but not the same object took about 700 ns
 * to record with the records' own method, and takes about 50 ns with this one.
 */
final class CallerEquality {

  private CallerEquality() {}

  static boolean areEqual(Caller one, Caller two) {
    return one.standing() == two.standing()
        && one.address().equals(two.address())
        && areEqual(one.member(), two.member())
        && haveEqualBehalf(one, two);
  }

  /** Hardly any call is on somebody's behalf. */
  private static boolean haveEqualBehalf(Caller one, Caller two) {
    return one.behalf().isEmpty() ? two.behalf().isEmpty() : one.behalf().equals(two.behalf());
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
