package org.dfra.river.phoenix;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import java.time.Duration;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

/** When a crashed group is started again, and when it is left alone. */
class RestartPolicyTest {

  private static final RestartPolicy POLICY =
      new RestartPolicy(
          Duration.ofMillis(100),
          Duration.ofMillis(1000),
          4,
          Duration.ofSeconds(60),
          Duration.ofSeconds(30));

  private final SteppedClock clock = new SteppedClock();
  private final CrashHistory history = new CrashHistory(POLICY, clock);

  @Test
  void delayDoublesFromTheSecondCrashUpToItsBound() {
    assertThat(IntStream.rangeClosed(0, 7).mapToObj(n -> POLICY.delay(n).toMillis()))
        .containsExactly(0L, 0L, 100L, 200L, 400L, 800L, 1000L, 1000L);
    assertThat(POLICY.delay(Integer.MAX_VALUE)).isEqualTo(Duration.ofMillis(1000));
  }

  @Test
  void refusesWhatMakesNoSense() {
    assertThatIllegalArgumentException()
        .isThrownBy(
            () -> new RestartPolicy(Duration.ZERO, Duration.ZERO, 1, Duration.ZERO, Duration.ZERO))
        .withMessage("restartLimit 1 < 2; one crash is no loop");
    assertThatIllegalArgumentException()
        .isThrownBy(
            () ->
                new RestartPolicy(
                    Duration.ofMillis(2), Duration.ofMillis(1), 2, Duration.ZERO, Duration.ZERO))
        .withMessage("restartDelay PT0.002S > restartLongestDelay PT0.001S");
  }

  @Test
  void firstCrashCostsNoDelayAndFurtherOnesMore() {
    history.crashed("ended");
    assertThat(history.restartDelay()).contains(Duration.ZERO);
    history.crashed("ended");
    assertThat(history.restartDelay()).contains(Duration.ofMillis(100));
    history.crashed("ended again");
    assertThat(history.restartDelay()).contains(Duration.ofMillis(200));
    assertThat(history.last()).contains("ended again");
    assertThat(history.heldOffUntil()).isEmpty();
  }

  @Test
  void crashLoopIsHeldOffAndNotForEver() {
    for (int crash = 0; crash < 4; crash++) {
      history.crashed("ended");
    }
    assertThat(history.restartDelay()).as("at the limit nobody starts it").isEmpty();
    assertThat(history.heldOffUntil()).contains(clock.instant().plusSeconds(30));
    clock.pass(Duration.ofMillis(29_999));
    assertThat(history.heldOffUntil()).isPresent();
    clock.pass(Duration.ofMillis(1));
    assertThat(history.heldOffUntil()).as("after the hold-off a call may start it").isEmpty();
    history.crashed("ended");
    assertThat(history.heldOffUntil())
        .as("a crash while the others still count holds it off again")
        .contains(clock.instant().plusSeconds(30));
  }

  @Test
  void oldCrashesNoLongerCountButStayInTheTotal() {
    history.crashed("ended");
    history.crashed("ended");
    clock.pass(Duration.ofSeconds(61));
    assertThat(history.recentCount()).isZero();
    history.crashed("ended");
    assertThat(history.restartDelay()).contains(Duration.ZERO);
    assertThat(history.total()).isEqualTo(3);
  }
}
