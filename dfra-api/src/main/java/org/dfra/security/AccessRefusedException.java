package org.dfra.security;

/** A guard has refused a call. It did not run, and its arguments were not read. */
public final class AccessRefusedException extends SecurityException {

  private static final long serialVersionUID = 1L;

  /**
   * @param message one sentence: who called what, which rule refused it, and what to do
   */
  public AccessRefusedException(String message) {
    super(message);
  }
}
