package org.dfra.core.policy;

import org.dfra.security.AccessRequest;
import org.dfra.security.Caller;
import org.dfra.security.Member;

/** The sentences in which refused callers learn what would have to be different. */
final class RefusalReason {

  private RefusalReason() {}

  static String ofNoRule(Policy policy, AccessRequest request) {
    return "no rule of "
        + policy
        + " permits "
        + call(request)
        + " to "
        + caller(request.caller())
        + "; ask an operator of "
        + policy.team()
        + " for a rule, or call as another member";
  }

  static String ofDenial(Policy policy, PolicyRule rule, AccessRequest request) {
    return rule(rule, policy)
        + " denies "
        + call(request)
        + " to "
        + caller(request.caller())
        + (rule.isConditional() ? ", " + String.join(", ", rule.conditions()) : "")
        + "; ask an operator of "
        + policy.team()
        + " to change it";
  }

  static String ofRate(Policy policy, PolicyRule rule, AccessRequest request) {
    return rule(rule, policy)
        + " permits "
        + call(request)
        + " to one caller "
        + rule.obligations().rate()
        + "; call less often";
  }

  static String ofMissingConfirmation(Policy policy, PolicyRule rule, AccessRequest request) {
    return rule(rule, policy)
        + " permits "
        + call(request)
        + " only when an operator has confirmed it; ask an operator to type \"policy requests\" and"
        + " \"policy confirm\", and call again within "
        + ConfirmationRequests.KEPT_SECONDS
        + " s of that";
  }

  static String ofRefusedConfirmation(Policy policy, PolicyRule rule, AccessRequest request) {
    return rule(rule, policy)
        + " permits "
        + call(request)
        + " only when an operator has confirmed it, and one has refused it; it can be asked for"
        + " again "
        + ConfirmationRequests.KEPT_SECONDS
        + " s after that";
  }

  private static String rule(PolicyRule rule, Policy policy) {
    return "rule " + rule.name() + " of " + policy;
  }

  private static String call(AccessRequest request) {
    return request.methodName() + (request.object().isEmpty() ? "" : " on " + request.object());
  }

  /** Without the address, which the reason must not depend on. */
  private static String caller(Caller caller) {
    return caller.member().map(Member::toString).orElse("a stranger")
        + caller.behalf().map(each -> " for " + each).orElse("")
        + (caller.standing() == Caller.Standing.EXPIRED ? ", whose certificate has expired" : "");
  }
}
