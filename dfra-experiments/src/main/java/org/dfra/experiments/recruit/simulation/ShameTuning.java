package org.dfra.experiments.recruit.simulation;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.dfra.experiments.recruit.simulation.Experiment.RunResult;
import org.dfra.experiments.recruit.simulation.ExperimentGrid.CellResult;
import org.dfra.experiments.recruit.simulation.ExperimentGrid.ExperimentCell;
import org.dfra.recruit.affect.Shame.ShameSettings;
import org.dfra.recruit.transport.Transport.MessageMode;

/**
 * Evaluates constants of shame on the tuning seeds: teams of six, by broadcast, at 10 % loss.
 * {@link ShameSettings#forField} was fixed before; the table shows the results of other choices.
 */
final class ShameTuning {

  private static final List<Double> GAINS = List.of(1.0, 1.5, 2.0, 3.0);
  private static final List<Double> EXPONENTS = List.of(1.0, 2.0, 3.0);

  /**
   * The result of one choice.
   *
   * @param transmissions per recruitment
   * @param allocation time to the choice, seconds
   */
  public record Trial(ShameSettings shame, Estimate transmissions, Estimate allocation) {

    @Override
    public String toString() {
      return String.format(
          Locale.ROOT,
          "g %.1f, p %.1f: %s transmissions, %s s to the choice",
          shame.gain(),
          shame.exponent(),
          transmissions,
          allocation);
    }
  }

  private ShameTuning() {}

  /** All evaluated choices. */
  public static List<Trial> trials(ExperimentPlan plan, int seeds, int threads)
      throws InterruptedException {
    List<Trial> trials = new ArrayList<>();
    ExperimentCell cell = new ExperimentCell("affective", MessageMode.BROADCAST, 6, 0.10);
    for (double gain : GAINS) {
      for (double exponent : EXPONENTS) {
        ShameSettings tried = plan.shame().withGain(gain, exponent);
        CellResult result =
            new Experiment(plan.with(tried), threads)
                .run(List.of(cell), Seeds.tuning(seeds), (done, all) -> {})
                .get(0);
        trials.add(
            new Trial(
                tried,
                result.mean(RunResult::transmissionsEach),
                result.mean(RunResult::allocation)));
      }
    }
    return trials;
  }
}
