package org.dfra.security;

/**
 * Decides which calls run. Asked for each call, after its method and before its arguments are read.
 * Thread-safe; it must not wait.
 */
@FunctionalInterface
public interface Guard {

  /** Decides about a call, and does what the decision obliges to, such as counting it. */
  Decision decide(AccessRequest request);

  /**
   * What a caller sees of the services that a lookup service lists. Asked for each call that reads
   * a lookup service, after {@link #decide} has permitted it, and for each event of one. A guard
   * that hides nothing need not implement it; one that asks another guard must pass it on.
   */
  default Visibility visibility(Caller caller) {
    return Visibility.ALL;
  }
}
