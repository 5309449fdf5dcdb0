package org.dfra.directory;

/**
 * A robot's registrar refused a registration: its service ID belongs to another computer, it claims
 * to be part of a robot that runs elsewhere, or there are too many from that address. Nothing was
 * registered. A retry can succeed only after the conflicting lease has ended, or after the
 * registrar was reconfigured.
 */
public final class RegistrationRefusedException extends SecurityException {

  private static final long serialVersionUID = 1L;

  /**
   * @param message one sentence: what was refused to which address, why, and what to do
   */
  public RegistrationRefusedException(String message) {
    super(message);
  }
}
