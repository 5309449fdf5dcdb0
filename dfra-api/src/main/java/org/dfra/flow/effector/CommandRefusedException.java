package org.dfra.flow.effector;

/**
 * A command was not obeyed, since it did not come from the effector's commander; the message says
 * who that is. Nothing has moved.
 */
public sealed class CommandRefusedException extends IllegalStateException
    permits StoppedCommandException {

  private static final long serialVersionUID = 1L;

  public CommandRefusedException(String message) {
    super(message);
  }
}
