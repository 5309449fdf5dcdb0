package org.dfra.core.behavior;

/**
 * The result of one step of a goal.
 *
 * @param outcome whether the goal is still in progress
 * @param activity what is being done, or why it has ended, as a clause for operators
 * @param completion fraction of the goal that is finished, 0 to 1
 * @param skippedParts how many of those parts were skipped because they could not be reached
 * @param completedParts how many of the goal's parts are finished
 * @param totalParts how many parts the goal has; 0 if they are not counted
 */
public record GoalProgress(
    GoalOutcome outcome,
    String activity,
    double completion,
    int skippedParts,
    int completedParts,
    int totalParts) {

  private GoalProgress(GoalOutcome outcome, String doing, double done) {
    this(outcome, doing, Math.max(0, Math.min(1, done)), 0, 0, 0);
  }

  /** Whether a goal is still in progress, or how it ended. */
  public enum GoalOutcome {
    IN_PROGRESS,
    REACHED,
    FAILED,
    CANCELLED,
    PAUSED
  }

  /** The goal is in progress. */
  public static GoalProgress inProgress(String doing, double done) {
    return new GoalProgress(GoalOutcome.IN_PROGRESS, doing, done);
  }

  /** The goal is reached. */
  public static GoalProgress reached(String what) {
    return new GoalProgress(GoalOutcome.REACHED, what, 1);
  }

  /** A delegated goal was cancelled, and so is the goal. */
  public static GoalProgress cancelled(String why, double done) {
    return new GoalProgress(GoalOutcome.CANCELLED, why, done);
  }

  /** A delegated goal was cancelled. The goal is paused and can be resumed. */
  public static GoalProgress paused(String why, double done) {
    return new GoalProgress(GoalOutcome.PAUSED, why, done);
  }

  /** The goal cannot be reached. */
  public static GoalProgress failed(String why, double done) {
    return new GoalProgress(GoalOutcome.FAILED, why, done);
  }

  /** A copy with this number of skipped parts. */
  public GoalProgress withSkippedParts(int number) {
    return new GoalProgress(outcome, activity, completion, number, completedParts, totalParts);
  }

  /** A copy with these numbers of finished and total parts. */
  public GoalProgress withParts(int now, int all) {
    return new GoalProgress(outcome, activity, completion, skippedParts, now, all);
  }
}
