package org.dfra.flow.effector;

/**
 * A command was not executed, since it did not come from the effector's commander, came too late,
 * or may not be executed now. The message gives the reason. Nothing has moved.
 */
public sealed class CommandRefusedException extends IllegalStateException
    permits CommandRefusedByEmergencyStopException, BrakeEngagedException {

  private static final long serialVersionUID = 1L;

  public CommandRefusedException(String message) {
    super(message);
  }
}
