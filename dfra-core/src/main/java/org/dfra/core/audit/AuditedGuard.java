package org.dfra.core.audit;

import java.lang.reflect.Method;
import java.util.List;
import java.util.function.Function;
import java.util.function.Predicate;
import org.dfra.security.AccessRequest;
import org.dfra.security.Decision;
import org.dfra.security.ForwardingGuard;
import org.dfra.security.Guard;

/**
 * Records what another guard decides. Permitted calls that only read and that oblige to nothing are
 * summed; all others are recorded. It never changes a decision, nor waits.
 */
public final class AuditedGuard extends ForwardingGuard {

  private final Guard guard;
  private final AuditTrail trail;
  private final Predicate<Method> reads;
  private final Function<Decision, List<String>> obligations;

  /**
   * @param guard which decides
   * @param reads whether a method only reads: it commands, stops and administers nothing. It is
   *     asked for each permitted call and must be fast.
   * @param obligations what a decision obliged the guard to do, such as {@code log}
   */
  public AuditedGuard(
      Guard guard,
      AuditTrail trail,
      Predicate<Method> reads,
      Function<Decision, List<String>> obligations) {
    this.guard = guard;
    this.trail = trail;
    this.reads = reads;
    this.obligations = obligations;
  }

  /** For a guard that obliges to nothing. */
  public AuditedGuard(Guard guard, AuditTrail trail, Predicate<Method> reads) {
    this(guard, trail, reads, decision -> List.of());
  }

  @Override
  protected Guard guard() {
    return guard;
  }

  /** Decides as the other guard does. What that throws is recorded and thrown here too. */
  @Override
  public Decision decide(AccessRequest request) {
    Decision decision;
    try {
      decision = guard.decide(request);
    } catch (RuntimeException | Error e) {
      trail.record(AuditEvent.undecided(request, e));
      throw e;
    }
    List<String> obliged = obligations.apply(decision);
    if (decision.isPermitted() && obliged.isEmpty() && reads.test(request.method())) {
      trail.recordRead(request);
    } else {
      trail.record(AuditEvent.call(request, decision, obliged));
    }
    return decision;
  }
}
