package org.dfra.app.mines;

import org.dfra.app.raster.ConfidenceInterval;

/** The frequency of an event among its trials. Mutable, confined to one thread. */
public final class DetectionRate {

  private int times;
  private int trials;

  void count(boolean happened) {
    trials++;
    times += happened ? 1 : 0;
  }

  void add(int moreTimes, int moreTrials) {
    times += moreTimes;
    trials += moreTrials;
  }

  /** Number of events. */
  public int times() {
    return times;
  }

  /** Number of trials. */
  public int trials() {
    return trials;
  }

  /**
   * The estimated rate: half an event is added to both outcomes, so that it is never 0 or 1, which
   * would mean certainty (the mean of Jeffreys' posterior); rounded to four decimals.
   */
  public double value() {
    double rate = (times + 0.5) / (trials + 1);
    return Math.max(1e-4, Math.min(1 - 1e-4, Math.rint(rate * 1e4) / 1e4));
  }

  /** Its Wilson interval of 95 %, around the observed share. */
  public ConfidenceInterval interval() {
    return trials == 0
        ? new ConfidenceInterval(Double.NaN, 0, 1)
        : ConfidenceInterval.ofProportion(times, trials);
  }
}
