package org.dfra.core.policy;

/** A policy is not signed by the team's authority. The message says why, and what to do. */
public final class PolicySignatureException extends Exception {

  private static final long serialVersionUID = 1L;

  PolicySignatureException(String message) {
    super(message);
  }

  PolicySignatureException(String message, Throwable cause) {
    super(message, cause);
  }
}
