package org.dfra.core.policy;

/** Whether a condition holds, as far as the robot knows. */
enum Truth {
  HOLDS,
  FAILS,
  /** A fact is not known: a permit does not apply then, and a denial does. */
  UNKNOWN;

  static Truth of(boolean holds) {
    return holds ? HOLDS : FAILS;
  }

  /** Whether a rule with such a condition applies. */
  boolean applies(PolicyRule.Effect effect) {
    return this == HOLDS || (this == UNKNOWN && effect == PolicyRule.Effect.DENY);
  }
}
