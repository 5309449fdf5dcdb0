package org.dfra.security;

/**
 * What a guard says to a call.
 *
 * @param isPermitted whether the call may run
 * @param rule name of the rule that decided
 * @param reason one sentence for a caller that is refused: what would have to be different; empty
 *     for a permission
 */
public record Decision(boolean isPermitted, String rule, String reason) {

  /** A permission. */
  public static Decision permit(String rule) {
    return new Decision(true, rule, "");
  }

  /** A refusal with its reason. */
  public static Decision deny(String rule, String reason) {
    return new Decision(false, rule, reason);
  }
}
