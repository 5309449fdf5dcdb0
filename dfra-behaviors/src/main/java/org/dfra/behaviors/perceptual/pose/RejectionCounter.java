package org.dfra.behaviors.perceptual.pose;

/** Counts consecutive rejections. */
final class RejectionCounter {

  private final int enough;
  private final long span;
  private int count;
  private long since;

  /**
   * @param enough limit of consecutive rejections
   * @param span minimum duration of the series, nanoseconds
   */
  RejectionCounter(int enough, long span) {
    this.enough = enough;
    this.span = span;
  }

  /** Counts one more; returns whether count and duration exceed the limits. */
  boolean recordRejection(long time) {
    since = count == 0 ? time : Math.min(since, time);
    count++;
    return count >= enough && time - since >= span;
  }

  /** Resets the count. */
  void clear() {
    count = 0;
  }

  /** Time of the first in the series, nanoseconds by the robot's clock. */
  long since() {
    return since;
  }
}
