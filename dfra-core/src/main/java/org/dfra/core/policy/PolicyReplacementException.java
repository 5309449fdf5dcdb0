package org.dfra.core.policy;

/** A policy cannot replace the present one. The message says why, and what to do. */
public final class PolicyReplacementException extends RuntimeException {

  private static final long serialVersionUID = 1L;

  PolicyReplacementException(String message) {
    super(message);
  }
}
