package org.dfra.core.behavior;

/**
 * What one turn has come to.
 *
 * @param outcome whether the goal is still being pursued
 * @param activity what is being done, or why it has ended, for people, as a clause
 * @param completion share of the goal that is dealt with, 0 to 1
 * @param skippedParts how many parts of that were left out, since they could not be reached
 * @param completedParts how many of the goal's parts are dealt with
 * @param totalParts how many parts the goal has; 0 where they are not counted
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

  /** Whether a goal is still being pursued. */
  public enum GoalOutcome {
    IN_PROGRESS,
    REACHED,
    FAILED,
    CANCELLED,
    PAUSED
  }

  /** It goes on. */
  public static GoalProgress inProgress(String doing, double done) {
    return new GoalProgress(GoalOutcome.IN_PROGRESS, doing, done);
  }

  /** The goal is reached. */
  public static GoalProgress reached(String what) {
    return new GoalProgress(GoalOutcome.REACHED, what, 1);
  }

  /** Somebody gave up what works for the goal, and so the goal. */
  public static GoalProgress cancelled(String why, double done) {
    return new GoalProgress(GoalOutcome.CANCELLED, why, done);
  }

  /** Somebody gave up what works for the goal. The goal is kept, paused, to be resumed. */
  public static GoalProgress paused(String why, double done) {
    return new GoalProgress(GoalOutcome.PAUSED, why, done);
  }

  /** The goal cannot be reached. */
  public static GoalProgress failed(String why, double done) {
    return new GoalProgress(GoalOutcome.FAILED, why, done);
  }

  /** The same, with so many parts of the goal left out. */
  public GoalProgress withSkippedParts(int number) {
    return new GoalProgress(outcome, activity, completion, number, completedParts, totalParts);
  }

  /** The same, with so many of the goal's parts dealt with. */
  public GoalProgress withParts(int now, int all) {
    return new GoalProgress(outcome, activity, completion, skippedParts, now, all);
  }
}
