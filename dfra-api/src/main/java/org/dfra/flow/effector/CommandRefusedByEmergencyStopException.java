package org.dfra.flow.effector;

/** A command was not executed, since the effector is in an emergency stop. Nothing has moved. */
public final class CommandRefusedByEmergencyStopException extends CommandRefusedException
    implements RefusedByEmergencyStop {

  private static final long serialVersionUID = 1L;

  public CommandRefusedByEmergencyStopException(String message) {
    super(message);
  }
}
