package org.dfra.core.budget;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** A radio whose listeners want more than it carries. */
class RadioThinningTest {

  private static final int STEPS = 60;
  private static final double MAX = 100;

  /** What is sent at a step, if the readings of each priority alone are this much. */
  private static double rate(double[] wanted, int[] oneIn, double others) {
    double sum = others;
    for (int i = 0; i < wanted.length; i++) {
      sum += wanted[i] / oneIn[i];
    }
    return sum;
  }

  private static int[] settled(double[] wanted, int[] from, double others) {
    int[] oneIn = from;
    for (int i = 0; i < STEPS; i++) {
      oneIn = RadioThinning.next(oneIn, rate(wanted, oneIn, others), MAX);
    }
    return oneIn;
  }

  /** The wanted rates of strangers, observers, robots, operators; then the settled n of each. */
  @ParameterizedTest
  @CsvSource({
    "  0,  90,   5,   5,  1,  1, 1, 1", // just enough
    "  0, 150,  20,  20, 64,  4, 1, 1", // observers get fewer
    "  0, 900,  20,  20, 64, 16, 1, 1",
    "500, 900,  20,  20, 64, 32, 1, 1",
    "  0, 900, 400,  20, 64, 64, 8, 1", // then robots
    "  0,   0,   0, 300, 64, 64, 64, 4", // operators last
  })
  void thinsThoseOfLowPriorityFirstUntilTheRateFits(
      double strangers,
      double observers,
      double robots,
      double operators,
      int s,
      int b,
      int r,
      int o) {
    double[] wanted = {strangers, observers, robots, operators};
    int[] oneIn = settled(wanted, RadioThinning.none(), 0);
    assertThat(rate(wanted, oneIn, 0)).isLessThanOrEqualTo(MAX);
    int[] priorities = {s, b, r, o};
    for (int i = 0; i < priorities.length; i++) {
      assertThat(oneIn[i])
          .as("n of %s", ListenerPriority.values()[i])
          .isLessThanOrEqualTo(priorities[i]);
      assertThat(oneIn[i] > 1)
          .as("%s thinned", ListenerPriority.values()[i])
          .isEqualTo(priorities[i] > 1);
    }
    assertThat(settled(wanted, oneIn, 0)).as("it does not swing").isEqualTo(oneIn);
  }

  @Test
  void allReadingsAreSentAgainAfterwards() {
    int[] thinned = settled(new double[] {0, 900, 400, 300}, RadioThinning.none(), 0);
    assertThat(settled(new double[] {0, 20, 5, 5}, thinned, 0)).isEqualTo(RadioThinning.none());
  }

  @Test
  void whatIsNotReadingsThinsAllButNotWithoutEnd() {
    int[] all = settled(new double[] {1, 1, 1, 1}, RadioThinning.none(), 5 * MAX);
    assertThat(all).containsOnly(RadioThinning.MOST);
  }
}
