package org.dfra.recruit.experiment;

/** What happened to the calls of a run. */
final class Diary {

  /** A mean of numbers as they come. */
  static final class Mean {
    private double sum;
    private int count;

    void add(double value) {
      sum += value;
      count++;
    }

    /** NaN where there was none. */
    double mean() {
      return count == 0 ? Double.NaN : sum / count;
    }
  }

  final Mean allocation = new Mean(); // seconds
  final Mean arrival = new Mean(); // seconds
  final Mean regret = new Mean(); // seconds
  int completed;
  int successes;
  double called; // seconds: when the current call was made
  Point place = new Point(0, 0);
  boolean isAwarded;
  private boolean hasArrived;
  private boolean isComplete;

  void call(double now, Point where) {
    called = now;
    place = where;
    isAwarded = false;
    hasArrived = false;
    isComplete = false;
  }

  void award(double now, double longer) {
    isAwarded = true;
    allocation.add(now - called);
    regret.add(longer);
  }

  void arrive(double now) {
    if (!hasArrived) {
      hasArrived = true;
      arrival.add(now - called);
    }
  }

  void complete(boolean inTime) {
    if (!isComplete) {
      isComplete = true;
      completed++;
      successes += inTime ? 1 : 0;
    }
  }
}
