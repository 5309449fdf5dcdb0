package org.dfra.drivers.uav.mavlink;

/**
 * The vehicle has not accepted a command that it was given; the message says which, which step of
 * it, and why. It comes after the call that gave the command has returned, so it is thrown to
 * nobody; it stands in the module's history, and who listens to the module is told.
 */
final class CommandFailedException extends Exception {

  private static final long serialVersionUID = 1L;

  CommandFailedException(String message) {
    super(message);
  }

  /** The message alone. */
  @Override
  public String toString() {
    return String.valueOf(getMessage());
  }
}
