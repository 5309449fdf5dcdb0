package org.dfra.core.policy;

import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import org.dfra.core.policy.PolicyRule.Effect;
import org.dfra.security.Behalf;
import org.dfra.security.Member;
import org.dfra.security.MemberRole;
import org.jspecify.annotations.Nullable;

/**
 * On whose behalf the callers of a rule call. A rule that names nobody is about calls that members
 * make for themselves; a denial is about all calls then.
 *
 * @param roles of those for whom they call; empty for all
 * @param members their names
 */
record BehalfCriteria(Set<MemberRole> roles, NamePattern members) {

  /** Nobody is named. */
  static final BehalfCriteria NONE = new BehalfCriteria(Set.of(), NamePattern.ANY);

  BehalfCriteria {
    roles = Set.copyOf(roles);
  }

  /** Whether the rule is about calls on somebody's behalf only. */
  boolean isNamed() {
    return !roles.isEmpty() || !members.isAny();
  }

  /** Why it is not about a call, as a part of a sentence; null if it is. */
  @Nullable String mismatch(Optional<Behalf> behalf, Effect effect) {
    if (!isNamed()) {
      return behalf.isEmpty() || effect == Effect.DENY
          ? null
          : "the call is on behalf of "
              + behalf.get()
              + ", which only for-role or for-member permits";
    }
    Optional<Member> principal = behalf.flatMap(Behalf::principal);
    if (principal.isEmpty()) {
      return "the caller calls on its own behalf";
    }
    if (!roles.isEmpty() && !roles.contains(principal.get().role())) {
      return "the call is on behalf of "
          + principal.get()
          + ", not of a member with role "
          + roles.stream().sorted().map(MemberRole::text).collect(Collectors.joining(" or "));
    }
    return members.matches(principal.get().name())
        ? null
        : "the call is on behalf of " + principal.get() + ", not of " + members;
  }
}
