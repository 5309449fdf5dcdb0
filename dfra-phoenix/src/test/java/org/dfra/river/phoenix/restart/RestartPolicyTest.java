package org.dfra.river.phoenix.restart;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import java.time.Duration;
import java.util.stream.IntStream;
import org.dfra.river.fixture.SteppedTime;
import org.junit.jupiter.api.Test;

/** When a crashed group is started again, and when it is left alone. */
class RestartPolicyTest {

  private static final RestartPolicy POLICY =
      new RestartPolicy(
          Duration.ofMillis(100),
          Duration.ofMillis(1000),
          4,
          Duration.ofSeconds(60),
          Duration.ofSeconds(30),
          Duration.ofSeconds(2));

  private final SteppedTime time = new SteppedTime();
  private final CrashHistory history = new CrashHistory(POLICY, time::nanos);

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
            () ->
                new RestartPolicy(
                    Duration.ZERO, Duration.ZERO, 1, Duration.ZERO, Duration.ZERO, Duration.ZERO))
        .withMessage("restartLimit 1 < 2; give 2 or more, since one crash is no loop");
    assertThatIllegalArgumentException()
        .isThrownBy(
            () ->
                new RestartPolicy(
                    Duration.ofMillis(2),
                    Duration.ofMillis(1),
                    2,
                    Duration.ZERO,
                    Duration.ZERO,
                    Duration.ZERO))
        .withMessage("restartDelay PT0.002S > restartMaxDelay PT0.001S; shorten restartDelay");
  }

  @Test
  void firstCrashCostsNoDelayAndFurtherOnesMore() {
    history.recordCrash("ended", false);
    assertThat(history.restartDelay()).contains(Duration.ZERO);
    history.recordCrash("ended", false);
    assertThat(history.restartDelay()).contains(Duration.ofMillis(100));
    history.recordCrash("ended again", false);
    assertThat(history.restartDelay()).contains(Duration.ofMillis(200));
    assertThat(history.lastCrash()).contains("ended again");
    assertThat(history.remainingHoldOff()).isEmpty();
  }

  @Test
  void crashLoopIsHeldOffAndNotForEver() {
    for (int crash = 0; crash < 4; crash++) {
      history.recordCrash("ended", false);
    }
    assertThat(history.restartDelay()).as("at the limit nobody starts it").isEmpty();
    assertThat(history.remainingHoldOff()).contains(Duration.ofSeconds(30));
    time.pass(Duration.ofMillis(29_999));
    assertThat(history.remainingHoldOff()).isPresent();
    time.pass(Duration.ofMillis(1));
    assertThat(history.remainingHoldOff()).as("after the hold-off a call may start it").isEmpty();
    history.recordCrash("ended", false);
    assertThat(history.remainingHoldOff())
        .as("a crash while the others still count holds it off again")
        .contains(Duration.ofSeconds(30));
  }

  @Test
  void oldCrashesNoLongerCountButStayInTheTotal() {
    history.recordCrash("ended", false);
    history.recordCrash("ended", false);
    time.pass(Duration.ofSeconds(61));
    assertThat(history.recentCount()).isZero();
    history.recordCrash("ended", false);
    assertThat(history.restartDelay()).contains(Duration.ZERO);
    assertThat(history.total()).isEqualTo(3);
  }

  @Test
  void whatHadWorkedIsRestartedAtOnceHoweverOftenItIsKilled() {
    for (int crash = 0; crash < 100; crash++) {
      time.pass(Duration.ofSeconds(5));
      history.recordCrash("ended (exit code 137)", true);
      assertThat(history.restartDelay()).as("after crash %d", crash).contains(Duration.ZERO);
      assertThat(history.remainingHoldOff()).isEmpty();
    }
    assertThat(history.total()).isEqualTo(100);
    assertThat(history.recentCount()).as("crashes within a minute").isBetween(12, 13);
    history.recordCrash("ended (exit code 137)", false);
    assertThat(history.restartDelay())
        .as("the first that had not worked for long")
        .contains(Duration.ZERO);
    history.recordCrash("ended (exit code 137)", false);
    assertThat(history.restartDelay()).contains(Duration.ofMillis(100));
  }

  @Test
  void aGroupThatIsAskedToEndIsDelayedButNeverHeldOff() {
    for (int end = 0; end < 20; end++) {
      history.recordRequestedExit(false);
      assertThat(history.remainingHoldOff()).isEmpty();
    }
    assertThat(history.total()).isZero();
    assertThat(history.recentCount()).isZero();
    assertThat(history.restartDelay().orElseThrow()).isPositive();
    history.recordRequestedExit(true);
    assertThat(history.restartDelay()).contains(Duration.ZERO);
  }

  @Test
  void workingInBetweenDoesNotHideACrashLoop() {
    for (int crash = 0; crash < 3; crash++) {
      history.recordCrash("ended", false);
    }
    history.recordCrash("ended", true);
    assertThat(history.restartDelay()).contains(Duration.ZERO);
    history.recordCrash("ended", false);
    assertThat(history.remainingHoldOff()).contains(Duration.ofSeconds(30));
  }
}
