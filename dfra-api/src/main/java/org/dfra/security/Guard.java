package org.dfra.security;

/**
 * Decides which calls run. Asked for each call, after its method and before its arguments are read.
 * Thread-safe; it must not wait.
 */
@FunctionalInterface
public interface Guard {

  /** Decides about a call, and does what the decision obliges to, such as counting it. */
  Decision decide(AccessRequest request);
}
