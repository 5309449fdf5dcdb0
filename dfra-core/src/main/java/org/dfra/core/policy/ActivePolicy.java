package org.dfra.core.policy;

import java.lang.reflect.Method;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.LongSupplier;
import org.dfra.core.policy.method.CalledMethod;
import org.dfra.core.policy.method.MethodKind;
import org.dfra.security.AccessRequest;
import org.dfra.security.Behalf;
import org.dfra.security.Caller;
import org.dfra.security.Decision;
import org.dfra.security.Member;
import org.dfra.security.Visibility;
import org.jspecify.annotations.Nullable;

/**
 * A policy in force, with what was already found out about it: which of its rules are about a
 * caller and a method. That never changes, so it is kept until the policy is replaced. Only
 * conditions and obligations are evaluated for each call.
 */
final class ActivePolicy {

  /** Callers, methods and objects are few; this limit is for a mistake. */
  static final int MAX_KNOWN = 10_000;

  private final Policy policy;
  private final Map<PolicyRule, CallRateLimiter> limiters = new IdentityHashMap<>();
  private final Map<String, List<String>> obligations = new HashMap<>(); // by rule; few have any
  private final ConcurrentHashMap<CallKey, Candidate[]> known = new ConcurrentHashMap<>();
  private final ConcurrentHashMap<CallerKey, Visibility> seen = new ConcurrentHashMap<>();

  /** What is seen depends on this. */
  private record CallerKey(Caller.Standing standing, @Nullable Member member) {

    /** As that of {@link CallKey}. */
    @Override
    public int hashCode() {
      return member == null ? standing.ordinal() : member.name().hashCode();
    }

    @Override
    public boolean equals(@Nullable Object other) {
      return other instanceof CallerKey key
          && standing == key.standing
          && (member == null ? key.member == null : member.equals(key.member));
    }
  }

  /**
   * A rule that may decide about a call.
   *
   * @param rule null for the refusal of calls that no rule matches
   * @param decision what is decided if it applies and its obligations are met
   * @param unmet what is decided if its obligations are not met; null if it has none to meet
   * @param limiter counts its calls; null if it has no rate
   * @param isImmediate whether it decides without conditions to evaluate and calls to count
   */
  record Candidate(
      @Nullable PolicyRule rule,
      Decision decision,
      @Nullable UnmetObligations unmet,
      Obligations obligations,
      @Nullable CallRateLimiter limiter,
      boolean isImmediate) {}

  /** The refusals for unmet obligations. They are made once: a caller may repeat them often. */
  record UnmetObligations(Decision tooOften, Decision notConfirmed, Decision refused) {}

  /** What the choice of rules depends on. */
  private record CallKey(
      Caller.Standing standing,
      @Nullable Member member,
      @Nullable Member principal,
      String robot,
      String object,
      Class<?> type,
      Method method) {

    /** Faster than that of a record, which would also read all parts of the member. */
    @Override
    public int hashCode() {
      int hash = member == null ? standing.ordinal() : member.name().hashCode();
      hash = 31 * hash + object.hashCode();
      hash = 31 * hash + method.getName().hashCode();
      return 31 * hash + type.hashCode();
    }

    @Override
    public boolean equals(@Nullable Object other) {
      return other instanceof CallKey key
          && standing == key.standing
          && type == key.type
          && method.equals(key.method)
          && object.equals(key.object)
          && robot.equals(key.robot)
          && (member == null ? key.member == null : member.equals(key.member))
          && (principal == null ? key.principal == null : principal.equals(key.principal));
    }
  }

  /**
   * @param nanos a monotonic clock in nanoseconds
   */
  ActivePolicy(Policy policy, LongSupplier nanos) {
    this.policy = policy;
    for (PolicyRule each : policy.rules()) {
      List<String> names = each.obligations().names();
      if (!names.isEmpty()) {
        obligations.put(each.name(), names);
      }
      Obligations.@Nullable RateLimit rate = each.obligations().rate();
      if (rate != null) {
        limiters.put(each, new CallRateLimiter(rate, nanos));
      }
    }
  }

  Policy policy() {
    return policy;
  }

  /** What a rule obliges to; empty if to nothing. */
  List<String> obligations(String rule) {
    return obligations.getOrDefault(rule, List.of());
  }

  /** The rules that may decide about a call, in their order; the last one always does. */
  Candidate[] candidates(AccessRequest request) {
    Caller caller = request.caller();
    CallKey key =
        new CallKey(
            caller.standing(),
            caller.member().orElse(null),
            caller.behalf().flatMap(Behalf::principal).orElse(null),
            request.robot(),
            request.object(),
            request.type(),
            request.method());
    Candidate @Nullable [] found = known.get(key);
    if (found != null) {
      return found;
    }
    if (known.size() >= MAX_KNOWN) {
      known.clear();
    }
    Candidate[] computed = compute(request);
    known.put(key, computed);
    return computed;
  }

  /** What a caller sees of the services that a lookup service lists. */
  Visibility visibility(Caller caller) {
    if (caller.standing() == Caller.Standing.OWN || policy.visibility().isEmpty()) {
      return Visibility.ALL;
    }
    CallerKey key = new CallerKey(caller.standing(), caller.member().orElse(null));
    @Nullable Visibility found = seen.get(key);
    if (found != null) {
      return found;
    }
    if (seen.size() >= MAX_KNOWN) {
      seen.clear();
    }
    Visibility made = PolicyVisibility.of(policy, caller);
    seen.put(key, made);
    return made;
  }

  private Candidate[] compute(AccessRequest request) {
    List<Candidate> candidates = new ArrayList<>();
    CalledMethod method = CalledMethod.of(request.type(), request.method());
    for (PolicyRule each : policy.rules()) {
      if (each.mismatches(request.caller(), method, request.robot(), request.object()).isEmpty()) {
        candidates.add(candidate(each, request, method.kind()));
        if (!each.isConditional()) {
          return candidates.toArray(Candidate[]::new);
        }
      }
    }
    Decision refusal = Decision.deny(Policy.DEFAULT_RULE, RefusalReason.ofNoRule(policy, request));
    candidates.add(new Candidate(null, refusal, null, Obligations.NONE, null, true));
    return candidates.toArray(Candidate[]::new);
  }

  private Candidate candidate(PolicyRule rule, AccessRequest request, MethodKind kind) {
    Decision decision =
        rule.effect() == PolicyRule.Effect.PERMIT
            ? Decision.permit(rule.name())
            : Decision.deny(rule.name(), RefusalReason.ofDenial(policy, rule, request));
    Obligations obligations = rule.obligations().of(kind);
    boolean isChecked = obligations.isChecked();
    @Nullable UnmetObligations unmet =
        isChecked
            ? new UnmetObligations(
                Decision.deny(rule.name(), RefusalReason.ofRate(policy, rule, request)),
                Decision.deny(
                    rule.name(), RefusalReason.ofMissingConfirmation(policy, rule, request)),
                Decision.deny(
                    rule.name(), RefusalReason.ofRefusedConfirmation(policy, rule, request)))
            : null;
    return new Candidate(
        rule,
        decision,
        unmet,
        obligations,
        isChecked ? limiters.get(rule) : null,
        !rule.isConditional() && !isChecked);
  }
}
