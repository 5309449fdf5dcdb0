package org.dfra.drivers.uav.mavlink;

/**
 * The vehicle has not accepted a command; the message states the command, its step, and the reason.
 * The failure occurs after the call that sent the command has returned, so it is not thrown; it is
 * recorded in the module's history and reported to the module's listeners.
 */
final class CommandFailedException extends Exception {

  private static final long serialVersionUID = 1L;

  CommandFailedException(String message) {
    super(message);
  }

  /** Only the message. */
  @Override
  public String toString() {
    return String.valueOf(getMessage());
  }
}
