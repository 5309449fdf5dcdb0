package org.dfra.experiments.recruit.simulation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.SplittableRandom;
import java.util.random.RandomGenerator;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Delays of the experiment are those that were measured. */
class MeasuredDelaysTest {

  @TempDir Path folder;

  /** A changed file would change the figures of every experiment: a new one has a new version. */
  @Test
  void thoseOfTheFirstVersionStay() {
    MeasuredDelays used = MeasuredDelays.ofMessages();
    assertThat(used.quantile(0)).isEqualTo(0.0002881);
    assertThat(used.quantile(0.5)).isCloseTo(0.00084025, within(1e-9));
    assertThat(used.quantile(1)).isEqualTo(0.0059812);
  }

  /** The tail too: as many of the drawn ones as of the measured ones are beyond 99 of 100. */
  @Test
  void whatIsDrawnIsDistributedAsWhatWasMeasured() {
    MeasuredDelays used = MeasuredDelays.ofMessages();
    long seed = 20261121;
    RandomGenerator random = new SplittableRandom(seed);
    int count = 100_000;
    double[] drawn = new double[count];
    Arrays.setAll(drawn, i -> used.next(random));
    for (double share : new double[] {0.1, 0.5, 0.9, 0.99}) {
      double limit = used.quantile(share);
      double found = (double) Arrays.stream(drawn).filter(each -> each <= limit).count() / count;
      // four standard deviations of a share of 100 000, 0.0063 at most
      assertThat(found).as("share %s, seed %s", share, seed).isCloseTo(share, within(0.0065));
    }
  }

  @Test
  void aFileWithoutNumbersIsRefusedWithItsLine() throws IOException {
    Path file = Files.writeString(folder.resolve("delays.csv"), "delay_ms\n1\nsoon\n");
    assertThatThrownBy(() -> MeasuredDelays.read(file))
        .isInstanceOf(IOException.class)
        .hasMessage(
            file
                + ":3: \"soon\" has no number in column delay_ms; write milliseconds, such as 1.5");
  }

  @ParameterizedTest
  @ValueSource(doubles = {-0.001, Double.NaN, Double.POSITIVE_INFINITY})
  void aDelayThatNoMessageCanHaveIsRefused(double delay) {
    assertThatThrownBy(() -> new MeasuredDelays(new double[] {0.001, delay}))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessage(
            "the list of measured delays is empty, or has one that is negative or not finite; give"
                + " finite delays of 0 or more");
  }
}
