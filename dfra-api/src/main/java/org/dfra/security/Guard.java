package org.dfra.security;

import java.util.function.UnaryOperator;

/**
 * Decides which calls run. Asked for each call, after its method and before its arguments are read.
 * Thread-safe; it must not wait, except to slow a call whose caller has used up its share.
 */
@FunctionalInterface
public interface Guard {

  /** What a guard wants to know of a call after it has ended. */
  enum Measurement {
    /** Nothing: {@link #ended} is not called. */
    NONE,
    /** Its bytes. */
    BYTES,
    /** Its bytes, and its processor time, which takes about a microsecond to measure. */
    BYTES_AND_PROCESSOR_TIME
  }

  /** Decides about a call, and does what the decision obliges to, such as counting it. */
  Decision decide(AccessRequest request);

  /**
   * As {@link #decide(AccessRequest)}, with a last word of somebody else on what it permits. That
   * is spoken before the call uses up what is for one call, such as an operator's confirmation: a
   * call that does not run uses none.
   *
   * @param last of a permission, makes the decision: the same one, or a refusal
   */
  default Decision decide(AccessRequest request, UnaryOperator<Decision> last) {
    Decision decision = decide(request);
    return decision.isPermitted() ? last.apply(decision) : decision;
  }

  /** What it wants to know of the next call. Asked for each call, so it must be fast. */
  default Measurement measurement() {
    return Measurement.NONE;
  }

  /**
   * A call that it has permitted has ended and its response was sent.
   *
   * @param request as it was decided
   */
  default void ended(AccessRequest request, CallUse use) {}

  /**
   * What a caller sees of the services that a lookup service lists. Asked for each call that reads
   * a lookup service, after {@link #decide} has permitted it, and for each event of one. A guard
   * that hides nothing need not implement it; one that asks another guard is a {@link
   * ForwardingGuard}.
   */
  default Visibility visibility(Caller caller) {
    return Visibility.ALL;
  }

  /**
   * What it says later about what its calls have obtained. A guard whose policy is never replaced
   * need not implement it; one that asks another guard is a {@link ForwardingGuard}.
   */
  default Permissions permissions() {
    return Permissions.LASTING;
  }
}
