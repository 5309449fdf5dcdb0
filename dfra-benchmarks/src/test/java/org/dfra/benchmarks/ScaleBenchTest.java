package org.dfra.benchmarks;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.function.DoubleUnaryOperator;
import java.util.stream.Stream;
import org.dfra.benchmarks.scale.TeamResult;
import org.dfra.benchmarks.scale.TeamResult.Load;
import org.dfra.benchmarks.scale.TeamResult.Mutual;
import org.dfra.benchmarks.scale.TeamResult.Observed;
import org.junit.jupiter.api.Test;

/** The exponent with which a figure grows. */
class ScaleBenchTest {

  private static List<TeamResult> growing(DoubleUnaryOperator bytes) {
    return Stream.of(2, 10, 30, 100)
        .map(
            robots -> {
              Load load = new Load(1, bytes.applyAsDouble(robots), 20);
              return new TeamResult(
                  robots, new Observed(1, load, load, List.of(0.5)), new Mutual(1, load, 0.1));
            })
        .toList();
  }

  private static double exponent(DoubleUnaryOperator bytes) {
    return ScaleBench.exponent(growing(bytes), each -> each.observed().observer().bytes());
  }

  @Test
  void isThatOfAPower() {
    assertThat(exponent(robots -> 7)).as("constant").isCloseTo(0, within(1e-9));
    assertThat(exponent(robots -> 3 * robots)).as("proportional").isCloseTo(1, within(1e-9));
    assertThat(exponent(robots -> robots * robots)).as("square").isCloseTo(2, within(1e-9));
  }

  @Test
  void isBetweenThoseOfItsParts() {
    assertThat(exponent(robots -> 100 * robots + robots * robots)).isBetween(1.0, 1.5);
  }
}
