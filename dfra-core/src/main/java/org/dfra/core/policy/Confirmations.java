package org.dfra.core.policy;

import org.dfra.security.AccessRequest;

/** Asks operators whether a call may run. Thread-safe; it does not wait for them. */
@FunctionalInterface
public interface Confirmations {

  /**
   * Whether an operator has confirmed such a call. If none has, the call is refused, and the
   * request is kept for the operators; the caller repeats the call later.
   *
   * @param rule the rule that obliges to it
   */
  boolean isConfirmed(AccessRequest request, PolicyRule rule);

  /** No operator can be asked, so nothing is confirmed. */
  static Confirmations none() {
    return (request, rule) -> false;
  }
}
