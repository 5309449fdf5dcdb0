package org.dfra.behaviors.perceptual.pose;

/** Counts what was disbelieved in a row. */
final class RejectionCounter {

  private final int enough;
  private final long span;
  private int count;
  private long since;

  /**
   * @param enough so many in a row are too many
   * @param span if they take as long as this, nanoseconds
   */
  RejectionCounter(int enough, long span) {
    this.enough = enough;
    this.span = span;
  }

  /** Counts one more; whether it is too many, for too long. */
  boolean recordRejection(long time) {
    since = count == 0 ? time : Math.min(since, time);
    count++;
    return count >= enough && time - since >= span;
  }

  /** Begins to count anew. */
  void clear() {
    count = 0;
  }

  /** Time of the first in the row, nanoseconds by the robot's clock. */
  long since() {
    return since;
  }
}
