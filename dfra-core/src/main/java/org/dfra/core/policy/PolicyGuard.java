package org.dfra.core.policy;

import java.time.InstantSource;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.LongSupplier;
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

  /** Whether a call is made, or what an earlier one has obtained is looked at again. */
  private enum Purpose {
    CALL,
    REVIEW
  }

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
    return decide(request, Purpose.CALL);
  }

  private Decision decide(AccessRequest request, Purpose purpose) {
    ActivePolicy now = active;
    AccessRequest known = recognised(request, now.policy());
    Optional<Behalf> behalf = known.caller().behalf();
    return behalf.isEmpty()
        ? decide(now, known, purpose)
        : decideOnBehalf(now, known, behalf.get(), purpose);
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

    @Override
    public boolean isStillPermitted(AccessRequest call) {
      return decide(call, Purpose.REVIEW).isPermitted();
    }

    @Override
    public Runnable onReplacement(Runnable listener) {
      replacementListeners.add(listener);
      return () -> replacementListeners.remove(listener);
    }
  }

  /**
   * Decides about a call on somebody's behalf: the caller must be permitted to make it for that
   * member, and that member to make it. A stop is the caller's own: what it carries may not prevent
   * it.
   */
  private Decision decideOnBehalf(
      ActivePolicy now, AccessRequest request, Behalf behalf, Purpose purpose) {
    AccessRequest alone = request.by(request.caller().alone());
    if (CalledMethod.of(request.type(), request.method()).kind() == MethodKind.STOP) {
      return decide(now, alone, purpose);
    }
    Optional<Member> principal = behalf.principal();
    if (principal.isEmpty()) {
      Decision unproved = Decision.deny(DELEGATION, behalf.fault());
      return observed(now, request, Obligations.NONE, unproved, purpose);
    }
    Decision bearer = decide(now, request, purpose);
    if (!bearer.isPermitted()) {
      return bearer;
    }
    Caller delegating = new Caller(Caller.Standing.MEMBER, principal, request.caller().address());
    Decision delegated = decide(now, request.by(delegating), purpose);
    return delegated.isPermitted()
        ? Decision.permit(bearer.rule() + BOTH + delegated.rule())
        : delegated;
  }

  private Decision decide(ActivePolicy now, AccessRequest known, Purpose purpose) {
    for (Candidate each : now.candidates(known)) {
      if (each.isImmediate()) {
        return observed(now, known, each.obligations(), each.decision(), purpose);
      }
      PolicyRule rule = each.rule();
      if (rule != null && rule.appliesNow(facts)) {
        Decision decision = purpose == Purpose.CALL ? checked(rule, each, known) : each.decision();
        return observed(now, known, each.obligations(), decision, purpose);
      }
    }
    throw new AssertionError("the last candidate always decides");
  }

  @Override
  public Visibility visibility(Caller caller) {
    ActivePolicy now = active;
    return now.visibility(recognised(caller.alone(), now.policy())); // it sees for itself
  }

  /** The decision of a rule that applies, after its rate and its confirmation are checked. */
  private Decision checked(PolicyRule rule, Candidate candidate, AccessRequest request) {
    ActivePolicy.@Nullable UnmetObligations unmet = candidate.unmet();
    if (unmet == null) {
      return candidate.decision();
    }
    boolean needsConfirmation = rule.obligations().isConfirmed();
    Confirmations.Answer answer =
        needsConfirmation ? confirmations.ask(request, rule) : Confirmations.Answer.CONFIRMED;
    if (answer != Confirmations.Answer.CONFIRMED) {
      return answer == Confirmations.Answer.NONE ? unmet.notConfirmed() : unmet.refused();
    }
    @Nullable CallRateLimiter limiter = candidate.limiter();
    if (limiter != null && !limiter.tryCall(request)) {
      return unmet.tooOften(); // which uses no confirmation
    }
    return !needsConfirmation || confirmations.use(request, rule)
        ? candidate.decision()
        : unmet.notConfirmed();
  }

  private Decision observed(
      ActivePolicy now,
      AccessRequest request,
      Obligations obligations,
      Decision decision,
      Purpose purpose) {
    if (purpose == Purpose.CALL && listener != null && listener.concerns(obligations)) {
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
