package org.dfra.experiments.recruit.simulation;

import org.dfra.experiments.recruit.simulation.ExperimentField.FieldPoint;

/** Statistics of the calls of a run. */
final class CallStatistics {

  /** A running mean. */
  static final class RunningMean {
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

  final RunningMean allocation = new RunningMean(); // seconds
  final RunningMean arrival = new RunningMean(); // seconds
  final RunningMean regret = new RunningMean(); // seconds
  int completed;
  int successes;
  double called; // seconds: time of the current call
  FieldPoint place = new FieldPoint(0, 0);
  boolean isAwarded;
  private boolean hasArrived;
  private boolean isComplete;

  void call(double now, FieldPoint where) {
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
