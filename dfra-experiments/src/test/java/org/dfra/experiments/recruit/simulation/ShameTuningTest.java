package org.dfra.experiments.recruit.simulation;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;

/** Constants are tried on seeds that judge nothing. */
class ShameTuningTest {

  @Test
  void everyChoiceIsTriedOnceAndOnlyGainAndExponentDiffer() throws InterruptedException {
    List<ShameTuning.Trial> trials = ShameTuning.trials(ExperimentPlan.DEFAULT, 2, 2);
    assertThat(trials).hasSize(12);
    assertThat(trials.stream().map(each -> each.shame().gain() + " " + each.shame().exponent()))
        .doesNotHaveDuplicates()
        .contains(
            ExperimentPlan.DEFAULT.shame().gain()
                + " "
                + ExperimentPlan.DEFAULT.shame().exponent());
    assertThat(trials)
        .allSatisfy(
            each -> {
              assertThat(each.shame().floor()).isEqualTo(ExperimentPlan.DEFAULT.shame().floor());
              assertThat(each.shame().busyFactor())
                  .isEqualTo(ExperimentPlan.DEFAULT.shame().busyFactor());
              // HELP, ACCEPT, RESPONDER_ID, ARRIVAL, AGREE, ACK_ACK at the least
              assertThat(each.transmissions().value()).isGreaterThanOrEqualTo(6);
              assertThat(each.allocation().value()).isGreaterThanOrEqualTo(1); // the window
            });
    assertThat(trials.get(0)).asString().startsWith("g 1.0, p 1.0: ");
  }

  /** The more ashamed they are, the sooner somebody offers. */
  @Test
  void aGreaterGainChoosesSooner() throws InterruptedException {
    List<ShameTuning.Trial> trials = ShameTuning.trials(ExperimentPlan.DEFAULT, 10, 2);
    double least = trials.get(0).allocation().value(); // g 1, p 1
    double most = trials.get(9).allocation().value(); // g 3, p 1
    assertThat(most).isLessThan(least);
  }

  @Test
  void noSeedThatJudgesIsUsed() {
    Set<Long> tried = new HashSet<>();
    Arrays.stream(Seeds.tuning(1000)).forEach(tried::add);
    assertThat(Arrays.stream(Seeds.evaluation(1000)).boxed()).doesNotContainAnyElementsOf(tried);
    assertThat(Arrays.stream(Seeds.replication(1000)).boxed())
        .doesNotContainAnyElementsOf(tried)
        .doesNotContainAnyElementsOf(Arrays.stream(Seeds.evaluation(1000)).boxed().toList());
  }
}
