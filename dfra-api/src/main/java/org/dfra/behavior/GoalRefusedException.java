package org.dfra.behavior;

/**
 * A goal was refused: it cannot be reached, or another one is in progress. The message gives the
 * reason and the remedy. Nothing has moved.
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

  /** Another goal is in progress; this one may be accepted later. */
  public static GoalRefusedException busy(String message) {
    return new GoalRefusedException(message, true);
  }

  /** Whether the goal was refused only because another one is in progress. */
  public boolean isBusy() {
    return isBusy;
  }
}
