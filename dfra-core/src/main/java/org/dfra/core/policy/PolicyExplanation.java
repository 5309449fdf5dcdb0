package org.dfra.core.policy;

import java.util.ArrayList;
import java.util.List;
import org.dfra.core.policy.PolicyRule.Effect;
import org.dfra.core.policy.method.CalledMethod;
import org.dfra.core.policy.method.MethodKind;
import org.dfra.security.Caller;
import org.jspecify.annotations.Nullable;

/**
 * Why a policy decides about a call as it does.
 *
 * @param outcome what it decides
 * @param deciding the rule that decides if no condition of an earlier one holds; null if no rule
 *     does, so that the call is refused
 * @param conditional rules before that one that decide instead while their conditions hold
 * @param nearMisses rules before that one that almost match: those about what is called but not
 *     about the caller, and those that name the caller but are not about what is called
 */
public record PolicyExplanation(
    Outcome outcome,
    @Nullable PolicyRule deciding,
    List<PolicyRule> conditional,
    List<NearMiss> nearMisses) {

  /** What a policy decides. */
  public enum Outcome {
    PERMIT,
    DENY,
    /** It depends on conditions, on a rate or on an operator's confirmation. */
    DEPENDS
  }

  /**
   * A rule that almost matches.
   *
   * @param reason why it does not, as a part of a sentence
   */
  public record NearMiss(PolicyRule rule, String reason) {}

  /** Copies the lists. */
  public PolicyExplanation {
    conditional = List.copyOf(conditional);
    nearMisses = List.copyOf(nearMisses);
  }

  /**
   * Explains a call.
   *
   * @param robot the robot that the called object belongs to; empty if to none
   * @param object name of the called object; empty if it has none
   */
  public static PolicyExplanation of(
      Policy policy, Caller caller, CalledMethod method, String robot, String object) {
    List<PolicyRule> conditional = new ArrayList<>();
    List<NearMiss> misses = new ArrayList<>();
    for (PolicyRule each : policy.rules()) {
      if (each.mismatches(caller, method, robot, object).isEmpty()) {
        if (!each.isConditional()) {
          return new PolicyExplanation(
              outcome(each, conditional, method.kind()), each, conditional, misses);
        }
        conditional.add(each);
      } else {
        @Nullable String reason = each.nearMiss(caller, method, robot, object);
        if (reason != null) {
          misses.add(new NearMiss(each, reason));
        }
      }
    }
    return new PolicyExplanation(
        outcome(null, conditional, method.kind()), null, conditional, misses);
  }

  private static Outcome outcome(
      @Nullable PolicyRule deciding, List<PolicyRule> conditional, MethodKind kind) {
    Effect effect = deciding == null ? Effect.DENY : deciding.effect();
    boolean isChecked = deciding != null && deciding.obligations().of(kind).isChecked();
    boolean isAlwaysSame =
        conditional.stream()
            .allMatch(each -> each.effect() == effect && !each.obligations().of(kind).isChecked());
    if (isChecked || !isAlwaysSame) {
      return Outcome.DEPENDS;
    }
    return effect == Effect.PERMIT ? Outcome.PERMIT : Outcome.DENY;
  }
}
