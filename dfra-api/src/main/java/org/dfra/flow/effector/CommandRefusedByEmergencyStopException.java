package org.dfra.flow.effector;

/** A command was not obeyed, since the effector is stopped for an emergency. Nothing has moved. */
public final class CommandRefusedByEmergencyStopException extends CommandRefusedException
    implements RefusedByEmergencyStop {

  private static final long serialVersionUID = 1L;

  public CommandRefusedByEmergencyStopException(String message) {
    super(message);
  }
}
