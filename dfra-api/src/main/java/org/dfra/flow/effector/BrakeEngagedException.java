package org.dfra.flow.effector;

/**
 * A velocity was not executed, since the drive's parking brake is set. Nothing has moved. An
 * operator may have set the brake, or a motor controller after a power cycle. So a program does not
 * release it: it pauses, and an operator who sees that the robot may move resumes it.
 */
public final class BrakeEngagedException extends CommandRefusedException {

  private static final long serialVersionUID = 1L;

  public BrakeEngagedException(String message) {
    super(message);
  }
}
