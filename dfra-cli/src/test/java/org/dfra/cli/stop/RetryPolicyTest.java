package org.dfra.cli.stop;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.rmi.ConnectException;
import java.time.Duration;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.function.BooleanSupplier;
import org.dfra.river.call.DeadlineExceededException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

@Timeout(60)
class RetryPolicyTest {

  private static final Duration TRY = Duration.ofSeconds(3);

  /** What the tries that are left fail with; the one after the last of them is answered. */
  private final Deque<Exception> failures = new ArrayDeque<>();

  private int tries;

  private CompletableFuture<String> once() {
    tries++;
    return failures.isEmpty()
        ? CompletableFuture.completedFuture("stopped")
        : CompletableFuture.<String>failedFuture(failures.remove()).thenApply(each -> each);
  }

  private CompletableFuture<String> call(BooleanSupplier isTimeLeft) {
    return new RetryPolicy(TRY, isTimeLeft)
        .run(this::once, failure -> RetryPolicy.cause(failure) instanceof IllegalStateException);
  }

  private static DeadlineExceededException silence() {
    return new DeadlineExceededException("emergencyStop", TRY, true);
  }

  @Test
  void whatFailsOnceIsTriedAgainAlsoWhereNoTimeIsLeft() throws Exception {
    failures.add(new ConnectException("refused"));
    assertThat(call(() -> false).get(20, TimeUnit.SECONDS)).isEqualTo("stopped");
    assertThat(tries).isEqualTo(2);
  }

  @Test
  void whatDoesNotAnswerIsTriedWhileThereIsTime() throws Exception {
    failures.addAll(List.of(silence(), new TimeoutException(), silence()));
    assertThat(call(() -> tries <= 3).get(20, TimeUnit.SECONDS)).isEqualTo("stopped");
    assertThat(tries).isEqualTo(4);
  }

  @Test
  void theLastSilenceIsReportedWhenTheTimeIsOver() {
    failures.addAll(List.of(silence(), silence(), silence(), silence()));
    CompletableFuture<String> answer = call(() -> tries < 3);
    assertThatThrownBy(() -> answer.get(20, TimeUnit.SECONDS))
        .hasCauseInstanceOf(DeadlineExceededException.class);
    assertThat(tries).isEqualTo(3);
  }

  /** It says that it was not answered, but was not sent: too many calls of its peer hang. */
  @Test
  void whatFailsAtOnceIsNotTriedThousandsOfTimes() throws Exception {
    for (int i = 0; i < 4; i++) {
      failures.add(silence());
    }
    long began = System.nanoTime();
    assertThat(call(() -> true).get(20, TimeUnit.SECONDS)).isEqualTo("stopped");
    assertThat(tries).isEqualTo(5);
    assertThat(System.nanoTime() - began)
        .as("three pauses")
        .isGreaterThanOrEqualTo(3 * RetryPolicy.BACKOFF.toNanos());
  }

  @Test
  void whatFailsOtherwiseIsTriedTwice() {
    failures.addAll(List.of(silence(), new ConnectException("refused"), silence()));
    CompletableFuture<String> answer = call(() -> true);
    assertThatThrownBy(() -> answer.get(20, TimeUnit.SECONDS))
        .hasCauseInstanceOf(ConnectException.class);
    assertThat(tries).isEqualTo(2);
  }

  @Test
  void whatNoRepetitionChangesIsNotRepeated() {
    failures.add(new IllegalStateException("no place"));
    CompletableFuture<String> answer = call(() -> true);
    assertThatThrownBy(() -> answer.get(20, TimeUnit.SECONDS))
        .hasCauseInstanceOf(IllegalStateException.class);
    assertThat(tries).isEqualTo(1);
  }
}
