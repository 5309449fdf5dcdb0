package org.dfra.core.behavior;

/**
 * Somebody stopped what was begun for a behaviour while it could not be asked about it. It is not
 * begun anew before a person has the behaviour go on.
 */
public final class DelegateHeldException extends RuntimeException {

  private static final long serialVersionUID = 1L;

  /** Of a sentence without the full stop. */
  public DelegateHeldException(String message) {
    super(message);
  }
}
