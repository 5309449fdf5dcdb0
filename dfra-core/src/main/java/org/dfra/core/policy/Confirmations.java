package org.dfra.core.policy;

import org.dfra.security.AccessRequest;

/** Asks operators whether a call may run. Thread-safe; it does not wait for them. */
public interface Confirmations {

  /** What operators have said about a call. */
  enum Answer {
    /** Nothing yet. */
    NONE,
    /** It may run, once. */
    CONFIRMED,
    /** It may not run for now. */
    REFUSED
  }

  /**
   * What operators have said about such a call. If nothing yet, the call is refused, and the
   * request is kept for the operators; the caller repeats the call later.
   *
   * @param rule the rule that obliges to it
   */
  Answer ask(AccessRequest request, PolicyRule rule);

  /**
   * Uses the confirmation of a call that is about to run: the next one needs another.
   *
   * @return false if there is none any more
   */
  boolean use(AccessRequest request, PolicyRule rule);

  /** No operator can be asked, so nothing is confirmed. */
  static Confirmations none() {
    return new Confirmations() {
      @Override
      public Answer ask(AccessRequest request, PolicyRule rule) {
        return Answer.NONE;
      }

      @Override
      public boolean use(AccessRequest request, PolicyRule rule) {
        return false;
      }
    };
  }
}
