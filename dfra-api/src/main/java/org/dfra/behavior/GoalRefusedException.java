package org.dfra.behavior;

/**
 * A goal was not taken up: it cannot be reached, or another one is being pursued; the message says
 * which, and what to do. Nothing has moved.
 */
public final class GoalRefusedException extends IllegalArgumentException {

  private static final long serialVersionUID = 2L;

  private final boolean isBusy;

  /** The goal cannot be reached. */
  public GoalRefusedException(String message) {
    this(message, false);
  }

  private GoalRefusedException(String message, boolean isBusy) {
    super(message);
    this.isBusy = isBusy;
  }

  /** Another goal is being pursued; later on this one may be taken up. */
  public static GoalRefusedException busy(String message) {
    return new GoalRefusedException(message, true);
  }

  /** Whether the goal itself could be reached, but for another that is being pursued now. */
  public boolean isBusy() {
    return isBusy;
  }
}
