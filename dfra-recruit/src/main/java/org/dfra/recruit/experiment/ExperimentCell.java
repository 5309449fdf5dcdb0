package org.dfra.recruit.experiment;

import java.util.Locale;
import org.dfra.recruit.transport.MessageMode;

/**
 * One combination of the varied parameters.
 *
 * @param strategy its name
 * @param mode transmission of messages to all
 * @param vehicles number of ground vehicles, two of which scan; there is one aircraft
 * @param loss fraction of messages lost, 0 to 1
 */
public record ExperimentCell(String strategy, MessageMode mode, int vehicles, double loss) {

  public ExperimentCell {
    if (vehicles < 1 || !(loss >= 0 && loss <= 1)) {
      throw new IllegalArgumentException(vehicles + " vehicles at a loss of " + loss);
    }
  }

  /** The same with another strategy. */
  public ExperimentCell with(String other) {
    return new ExperimentCell(other, mode, vehicles, loss);
  }

  /** {@code affective, broadcast, 6 vehicles, 10 % loss}. */
  @Override
  public String toString() {
    return String.format(
        Locale.ROOT,
        "%s, %s, %d vehicles, %.0f %% loss",
        strategy,
        mode.name().toLowerCase(Locale.ROOT),
        vehicles,
        100 * loss);
  }
}
