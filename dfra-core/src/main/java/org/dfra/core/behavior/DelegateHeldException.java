package org.dfra.core.behavior;

/**
 * A delegated goal was stopped while its worker was unreachable. It is not started again until an
 * operator resumes the behaviour.
 */
public final class DelegateHeldException extends RuntimeException {

  private static final long serialVersionUID = 1L;

  /** @param message a sentence without the full stop */
  public DelegateHeldException(String message) {
    super(message);
  }
}
