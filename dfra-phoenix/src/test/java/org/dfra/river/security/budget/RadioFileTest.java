package org.dfra.river.security.budget;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Path;
import org.dfra.core.budget.ListenerPriority;
import org.dfra.core.budget.RadioThinning;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Two processes of a computer measure its radio together. */
class RadioFileTest {

  private static final double MAX = 100_000;
  private static final int OBSERVER = ListenerPriority.OBSERVER.ordinal();
  private static final int OPERATOR = ListenerPriority.OPERATOR.ordinal();

  @TempDir Path folder;
  private long nanos = 7 * RadioFile.STEP_NANOS;

  /** Each sends as many bytes in each step. */
  private void send(long bytes, int steps, RadioFile... processes) {
    for (int i = 0; i < steps; i++) {
      nanos += RadioFile.STEP_NANOS;
      for (RadioFile each : processes) {
        each.add(bytes, MAX, nanos);
      }
    }
  }

  @Test
  void thinsAllTogetherWhatTheySendTogether() throws IOException {
    Path file = folder.resolve("radio");
    RadioFile one = RadioFile.open(file);
    RadioFile other = RadioFile.open(file);
    send(10_000, 20, one, other);
    assertThat(one.rate()).isEqualTo(80_000, within(1_000.0));
    assertThat(other.oneIn()).isEqualTo(RadioThinning.none());
    send(20_000, 8, one, other);
    assertThat(one.rate()).isEqualTo(160_000, within(5_000.0));
    assertThat(one.oneIn()).isEqualTo(other.oneIn());
    assertThat(one.oneIn()[OBSERVER]).isGreaterThan(1);
    assertThat(one.oneIn()[OPERATOR]).isEqualTo(1);
    assertThat(RadioFile.open(file).oneIn()).as("a process that starts").isEqualTo(one.oneIn());
    send(0, 40, other); // the first one has died
    assertThat(other.oneIn()).isEqualTo(RadioThinning.none());
  }

  @Test
  void beginsAgainAfterAPauseAndAfterARestartOfTheComputer() throws IOException {
    RadioFile file = RadioFile.open(folder.resolve("radio"));
    send(100_000, 10, file);
    assertThat(file.oneIn()[OBSERVER]).isGreaterThan(1);
    nanos += 1000 * RadioFile.STEP_NANOS;
    send(100, 1, file);
    assertThat(file.oneIn()).isEqualTo(RadioThinning.none());
    send(100_000, 10, file);
    nanos = 0; // the clock of a computer that has just started
    send(100, 1, file);
    assertThat(file.oneIn()).isEqualTo(RadioThinning.none());
    assertThat(file.rate()).isZero();
    send(10_000, 20, file);
    assertThat(file.rate()).isEqualTo(40_000, within(1_000.0));
  }
}
