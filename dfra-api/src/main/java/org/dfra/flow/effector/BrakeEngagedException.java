package org.dfra.flow.effector;

/**
 * A velocity was not executed, since the drive's parking brake is set. Nothing has moved. The brake
 * may have been set by a person, or by a controller that was switched off and on, so a program does
 * not release it to go on: it pauses, and somebody who sees that the robot may move has it resume.
 */
public final class BrakeEngagedException extends CommandRefusedException {

  private static final long serialVersionUID = 1L;

  public BrakeEngagedException(String message) {
    super(message);
  }
}
