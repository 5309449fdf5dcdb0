package org.dfra.core.budget;

import java.io.Serializable;

/**
 * What one account of a budget may use. {@link #UNLIMITED} where there is no limit.
 *
 * @param bytes sent and received on the network, per second
 * @param calls per second
 * @param processorTime of the threads that serve its calls, in seconds per second
 * @param listeners registered at the same time
 */
public record BudgetLimits(double bytes, double calls, double processorTime, double listeners)
    implements Serializable {

  /** No limit. */
  public static final double UNLIMITED = Double.POSITIVE_INFINITY;

  /** No limits at all. */
  public static final BudgetLimits NONE =
      new BudgetLimits(UNLIMITED, UNLIMITED, UNLIMITED, UNLIMITED);

  /**
   * Checks them.
   *
   * @throws IllegalArgumentException if one is not above zero
   */
  public BudgetLimits {
    if (!(bytes > 0 && calls > 0 && processorTime > 0 && listeners > 0)) {
      throw new IllegalArgumentException(
          "limits must be above 0: %s B/s, %s calls/s, %s s/s, %s listeners"
              .formatted(bytes, calls, processorTime, listeners));
    }
  }

  double of(BudgetResource resource) {
    return switch (resource) {
      case BYTES -> bytes;
      case CALLS -> calls;
      case PROCESSOR_TIME -> processorTime;
    };
  }
}
