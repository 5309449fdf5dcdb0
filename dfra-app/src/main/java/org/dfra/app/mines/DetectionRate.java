package org.dfra.app.mines;

import org.dfra.app.raster.ConfidenceInterval;

/**
 * How often something happened of the times that it could have. Mutable, confined to one thread.
 */
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

  /** Times that it happened. */
  public int times() {
    return times;
  }

  /** Times that it could have happened. */
  public int trials() {
    return trials;
  }

  /**
   * The rate as it is reckoned with: half a time is added to both outcomes, so that it is never 0
   * nor 1, since that would leave no doubt (the mean of Jeffreys' posterior); to four decimals.
   */
  public double value() {
    double rate = (times + 0.5) / (trials + 1);
    return Math.max(1e-4, Math.min(1 - 1e-4, Math.rint(rate * 1e4) / 1e4));
  }

  /** Its Wilson interval of 95 %, around the plain share. */
  public ConfidenceInterval interval() {
    return trials == 0
        ? new ConfidenceInterval(Double.NaN, 0, 1)
        : ConfidenceInterval.ofProportion(times, trials);
  }
}
