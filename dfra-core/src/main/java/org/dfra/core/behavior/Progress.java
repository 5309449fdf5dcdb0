package org.dfra.core.behavior;

/**
 * What one turn has come to.
 *
 * @param outcome whether the goal is still being pursued
 * @param doing what is being done, or why it has ended, for people, as a clause
 * @param done share of the goal that is dealt with, 0 to 1
 * @param missed how many parts of that were left out, since they could not be reached
 * @param partsDone how many of the goal's parts are dealt with
 * @param parts how many parts the goal has; 0 where they are not counted
 */
public record Progress(
    Outcome outcome, String doing, double done, int missed, int partsDone, int parts) {

  private Progress(Outcome outcome, String doing, double done) {
    this(outcome, doing, Math.max(0, Math.min(1, done)), 0, 0, 0);
  }

  /** Whether a goal is still being pursued. */
  public enum Outcome {
    GOING_ON,
    REACHED,
    FAILED,
    CANCELLED,
    HELD
  }

  /** It goes on. */
  public static Progress going(String doing, double done) {
    return new Progress(Outcome.GOING_ON, doing, done);
  }

  /** The goal is reached. */
  public static Progress reached(String what) {
    return new Progress(Outcome.REACHED, what, 1);
  }

  /** Somebody gave up what works for the goal, and so the goal. */
  public static Progress cancelled(String why, double done) {
    return new Progress(Outcome.CANCELLED, why, done);
  }

  /** Somebody gave up what works for the goal. The goal is kept, paused, to be resumed. */
  public static Progress held(String why, double done) {
    return new Progress(Outcome.HELD, why, done);
  }

  /** The goal cannot be reached. */
  public static Progress failed(String why, double done) {
    return new Progress(Outcome.FAILED, why, done);
  }

  /** The same, with so many parts of the goal left out. */
  public Progress missing(int number) {
    return new Progress(outcome, doing, done, number, partsDone, parts);
  }

  /** The same, with so many of the goal's parts dealt with. */
  public Progress counting(int now, int all) {
    return new Progress(outcome, doing, done, missed, now, all);
  }
}
