package org.dfra.core.policy;

import java.time.InstantSource;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.LongSupplier;
import java.util.function.UnaryOperator;
import java.util.stream.Stream;
import org.dfra.core.policy.ActivePolicy.Candidate;
import org.dfra.core.policy.method.CalledMethod;
import org.dfra.core.policy.method.MethodKind;
import org.dfra.security.AccessRequest;
import org.dfra.security.Behalf;
import org.dfra.security.Caller;
import org.dfra.security.Decision;
import org.dfra.security.Guard;
import org.dfra.security.Member;
import org.dfra.security.Permissions;
import org.dfra.security.Visibility;
import org.jspecify.annotations.Nullable;

/**
 * Decides about calls by a policy, which can be replaced while calls are made. A call is decided
 * entirely by one policy, the old one or the new one. Thread-safe; it waits for nothing.
 *
 * <p>A member of another team than the policy's counts as a stranger. A call on somebody's behalf
 * is decided twice, for the caller and for that member, and runs only if both are permitted.
 */
public final class PolicyGuard implements Guard {

  /** The rule that refuses a call whose credential proves nothing. */
  public static final String DELEGATION = "delegation";

  /** Between the two rules that permit a call on somebody's behalf. */
  private static final String BOTH = ", ";

  private final PolicyFacts facts;
  private final Confirmations confirmations;
  private final @Nullable DecisionListener listener;
  private final InstantSource clock;
  private final LongSupplier nanos;
  private final Permissions permissions = new PresentPermissions();
  private final List<Runnable> replacementListeners = new CopyOnWriteArrayList<>();
  private volatile ActivePolicy active; // written by replace only

  /** A guard without facts, confirmations and listener. */
  public PolicyGuard(Policy policy) {
    this(
        policy,
        PolicyFacts.none(),
        Confirmations.none(),
        null,
        InstantSource.system(),
        System::nanoTime);
  }

  /**
   * @param facts for the conditions of rules
   * @param listener observes each decision; null for none
   * @param clock for the times of the observed decisions
   * @param nanos a monotonic clock in nanoseconds, for rates
   */
  public PolicyGuard(
      Policy policy,
      PolicyFacts facts,
      Confirmations confirmations,
      @Nullable DecisionListener listener,
      InstantSource clock,
      LongSupplier nanos) {
    this.facts = facts;
    this.confirmations = confirmations;
    this.listener = listener;
    this.clock = clock;
    this.nanos = nanos;
    this.active = new ActivePolicy(policy, nanos);
  }

  /** The policy in force. */
  public Policy policy() {
    return active.policy();
  }

  @Override
  public Decision decide(AccessRequest request) {
    return decide(request, UnaryOperator.identity());
  }

  @Override
  public Decision decide(AccessRequest request, UnaryOperator<Decision> last) {
    ActivePolicy now = active;
    AccessRequest known = recognised(request, now.policy());
    Optional<Behalf> behalf = known.caller().behalf();
    return behalf.isEmpty()
        ? decide(now, known, last)
        : decideOnBehalf(now, known, behalf.get(), last);
  }

  private Decision decide(ActivePolicy now, AccessRequest request, UnaryOperator<Decision> last) {
    Candidate rule = deciding(now, request);
    Decision decision = rule.decision();
    if (rule.unmet() != null) {
      decision = checked(List.of(new Permission(rule, request)), request, decision, last);
    } else if (decision.isPermitted()) {
      decision = last.apply(decision);
    }
    return observed(now, request, rule.obligations(), decision);
  }

  /**
   * Decides about a call on somebody's behalf: the caller must be permitted to make it for that
   * member, and that member to make it. A stop is the caller's own: what it carries may not prevent
   * it.
   */
  private Decision decideOnBehalf(
      ActivePolicy now, AccessRequest request, Behalf behalf, UnaryOperator<Decision> last) {
    if (CalledMethod.of(request.type(), request.method()).kind() == MethodKind.STOP) {
      return decide(now, request.by(request.caller().alone()), last);
    }
    Optional<Member> principal = behalf.principal();
    if (principal.isEmpty()) {
      return observed(now, request, Obligations.NONE, Decision.deny(DELEGATION, behalf.fault()));
    }
    Candidate bearer = deciding(now, request);
    if (!bearer.decision().isPermitted()) {
      return observed(now, request, bearer.obligations(), bearer.decision());
    }
    AccessRequest delegated = request.by(delegating(principal.get(), request.caller()));
    Candidate second = deciding(now, delegated);
    Obligations both = bearer.obligations().and(second.obligations());
    if (!second.decision().isPermitted()) {
      return observed(now, request, both, second.decision());
    }
    Decision permitted =
        Decision.permit(bearer.decision().rule() + BOTH + second.decision().rule());
    List<Permission> permissions =
        List.of(new Permission(bearer, request), new Permission(second, delegated));
    return observed(now, request, both, checked(permissions, request, permitted, last));
  }

  /** The rule that decides about a call, as far as its conditions are concerned. */
  private Candidate deciding(ActivePolicy now, AccessRequest known) {
    for (Candidate each : now.candidates(known)) {
      PolicyRule rule = each.rule();
      if (each.isImmediate() || (rule != null && rule.appliesNow(facts))) {
        return each;
      }
    }
    throw new AssertionError("the last candidate always decides");
  }

  @Override
  public Permissions permissions() {
    return permissions;
  }

  /** What the present policy says about calls of earlier ones. */
  private final class PresentPermissions implements Permissions {

    @Override
    public long version() {
      return policy().version();
    }

    /** Nothing is counted, asked or recorded: rates and confirmations are for the call alone. */
    @Override
    public boolean isStillPermitted(AccessRequest call) {
      ActivePolicy now = active;
      AccessRequest known = recognised(call, now.policy());
      Caller caller = known.caller();
      Optional<Behalf> behalf = caller.behalf();
      if (behalf.isEmpty()) {
        return isPermitted(now, known);
      }
      if (CalledMethod.of(known.type(), known.method()).kind() == MethodKind.STOP) {
        return isPermitted(now, known.by(caller.alone()));
      }
      return isPermitted(now, known)
          && behalf
              .get()
              .principal()
              .filter(each -> isPermitted(now, known.by(delegating(each, caller))))
              .isPresent();
    }

    private boolean isPermitted(ActivePolicy now, AccessRequest request) {
      return deciding(now, request).decision().isPermitted();
    }

    @Override
    public Runnable onReplacement(Runnable listener) {
      replacementListeners.add(listener);
      return () -> replacementListeners.remove(listener);
    }
  }

  /** A principal, as if it made the call of a bearer. */
  private static Caller delegating(Member principal, Caller bearer) {
    return new Caller(Caller.Standing.MEMBER, Optional.of(principal), bearer.address());
  }

  @Override
  public Visibility visibility(Caller caller) {
    ActivePolicy now = active;
    return now.visibility(recognised(caller.alone(), now.policy())); // it sees for itself
  }

  /**
   * A rule that permits a call.
   *
   * @param counted the call, by the caller to whom the rule permits it
   */
  private record Permission(Candidate rule, AccessRequest counted) {}

  /**
   * The decision about a call that rules permit, after their rates and confirmations are checked. A
   * confirmation is used last: a call that does not run uses none. All that are missing are asked
   * for at once.
   *
   * @param request the call as it is made, which is what an operator confirms
   */
  private Decision checked(
      List<Permission> permissions,
      AccessRequest request,
      Decision permitted,
      UnaryOperator<Decision> last) {
    @Nullable Decision missing = null;
    for (Permission each : permissions) {
      ActivePolicy.@Nullable UnmetObligations unmet = each.rule().unmet();
      @Nullable PolicyRule rule = asking(each);
      if (unmet != null && rule != null) {
        switch (confirmations.ask(request, rule)) {
          case REFUSED -> {
            return unmet.refused();
          }
          case NONE -> missing = unmet.notConfirmed();
          case CONFIRMED -> {}
        }
      }
    }
    if (missing != null) {
      return missing;
    }
    for (Permission each : permissions) {
      @Nullable CallRateLimiter limiter = each.rule().limiter();
      ActivePolicy.@Nullable UnmetObligations unmet = each.rule().unmet();
      if (unmet != null && limiter != null && !limiter.tryCall(each.counted())) {
        return unmet.tooOften();
      }
    }
    Decision decision = last.apply(permitted);
    for (Permission each : permissions) {
      @Nullable PolicyRule rule = asking(each);
      ActivePolicy.@Nullable UnmetObligations unmet = each.rule().unmet();
      if (decision.isPermitted()
          && unmet != null
          && rule != null
          && !confirmations.use(request, rule)) {
        return unmet.notConfirmed();
      }
    }
    return decision;
  }

  /** The rule, if it obliges to ask an operator. */
  private static @Nullable PolicyRule asking(Permission permission) {
    @Nullable PolicyRule rule = permission.rule().rule();
    return rule != null && rule.obligations().isConfirmed() ? rule : null;
  }

  private Decision observed(
      ActivePolicy now, AccessRequest request, Obligations obligations, Decision decision) {
    if (listener != null && listener.concerns(obligations)) {
      listener.onDecision(
          new DecisionRecord(
              clock.instant(), request, decision, now.policy().version(), obligations));
    }
    return decision;
  }

  /** What the rules of a decision oblige to, such as {@code log}; empty if to nothing. */
  public List<String> obligations(Decision decision) {
    ActivePolicy now = active;
    String rule = decision.rule();
    List<String> its = now.obligations(rule);
    return its.isEmpty() && rule.contains(BOTH)
        ? Stream.of(rule.split(BOTH))
            .flatMap(each -> now.obligations(each).stream())
            .distinct()
            .toList()
        : its;
  }

  /** The request, with a stranger in place of a member of another team. */
  private static AccessRequest recognised(AccessRequest request, Policy policy) {
    Caller caller = recognised(request.caller(), policy);
    return caller == request.caller()
        ? request
        : new AccessRequest(
            caller, request.robot(), request.object(), request.type(), request.method());
  }

  private static Caller recognised(Caller caller, Policy policy) {
    return caller.member().isEmpty() || caller.member().get().team().equals(policy.team())
        ? caller
        : Caller.stranger(caller.address());
  }

  /**
   * Replaces the policy: later calls are decided by the new one. Counts of rates begin again. Then
   * calls the listeners of {@link #permissions}.
   *
   * @param next has a higher version than the present one, and is of the same team
   * @return false, with nothing changed, if it is the present one
   * @throws PolicyReplacementException if it is older, of another team, or a different one of the
   *     same version
   */
  public boolean replace(Policy next) {
    synchronized (this) {
      if (!policy().identity().isReplacedBy(next.identity(), next.place().file())) {
        return false;
      }
      active = new ActivePolicy(next, nanos);
    }
    replacementListeners.forEach(Runnable::run);
    return true;
  }
}
