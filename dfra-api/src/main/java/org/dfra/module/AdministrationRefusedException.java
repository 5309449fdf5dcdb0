package org.dfra.module;

/**
 * An {@link Administrative} method was called from an address that may not administer the robot.
 * The method did not run, and its arguments were not read.
 */
public final class AdministrationRefusedException extends SecurityException {

  private static final long serialVersionUID = 1L;

  /** @param message one sentence: the method, the caller's address, and what to configure */
  public AdministrationRefusedException(String message) {
    super(message);
  }
}
