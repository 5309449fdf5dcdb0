package org.dfra.recruit.transport;

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

/** Delays of the experiment are those that were measured. */
class MeasuredDelaysTest {

  private static final Path MEASURED =
      Path.of(System.getProperty("dfra.root", "."), "benchmarks", "recruit-letter-delays.csv");

  @TempDir Path folder;

  @Test
  void thoseOfLettersAreThoseOfTheBenchmark() throws IOException {
    MeasuredDelays file = MeasuredDelays.read(MEASURED);
    MeasuredDelays used = MeasuredDelays.ofMessages();
    for (double share : new double[] {0, 0.1, 0.5, 0.9, 0.99, 1}) {
      assertThat(used.quantile(share)).as("%s", share).isEqualTo(file.quantile(share));
    }
    assertThat(used.quantile(0)).isPositive();
  }

  /** The tail too: as many of the drawn ones as of the measured ones are beyond 99 of 100. */
  @Test
  void whatIsDrawnIsDistributedAsWhatWasMeasured() {
    MeasuredDelays used = MeasuredDelays.ofMessages();
    long seed = 20261121;
    RandomGenerator lot = new SplittableRandom(seed);
    int count = 100_000;
    double[] drawn = new double[count];
    Arrays.setAll(drawn, i -> used.next(lot));
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
        .hasMessage(file + ":3: no number in column delay_ms");
  }
}
