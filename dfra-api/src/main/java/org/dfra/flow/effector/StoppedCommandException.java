package org.dfra.flow.effector;

/** A command was not obeyed, since the effector is stopped for an emergency. Nothing has moved. */
public final class StoppedCommandException extends CommandRefusedException
    implements StoppedForEmergency {

  private static final long serialVersionUID = 1L;

  public StoppedCommandException(String message) {
    super(message);
  }
}
