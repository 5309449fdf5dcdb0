package org.dfra.security;

/**
 * What a guard says later about what calls have obtained, such as leases, subscriptions and goals:
 * whether it may go on when the policy was replaced. Thread-safe; it must not wait.
 */
public interface Permissions {

  /** Of a guard whose policy is never replaced: what was permitted goes on. */
  Permissions LASTING = new LastingPermissions();

  /** Version of the policy in force. */
  long version();

  /**
   * Whether the policy in force permits what a call has obtained. It decides as about the same call
   * made now, except that rates are not counted and confirmations count as given: they are for the
   * call alone.
   *
   * @param call as it was permitted
   */
  boolean isStillPermitted(AccessRequest call);

  /**
   * Calls back each time that the policy was replaced, on the thread that has replaced it.
   *
   * @param listener must not wait
   * @return ends it
   */
  Runnable onReplacement(Runnable listener);
}
