package org.dfra.cli.stop;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.net.InetAddress;
import java.net.ServerSocket;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.UUID;
import java.util.concurrent.Callable;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import org.dfra.cli.stop.Outcome.Result;
import org.dfra.river.call.PeerAddress;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** No source of calls keeps those of another waiting. */
@Timeout(60)
class FairCallSchedulerTest {

  private static final Duration LONG = Duration.ofSeconds(50);
  private static final Duration BRIEF = Duration.ofMillis(20);
  private static final UUID STRANGERS = new UUID(6, 6);
  private static final UUID HONEST = new UUID(1, 1);
  private static final Outcome STOPPED =
      new Outcome("atrv1/drive", Result.STOPPED, "ops", null, null);

  private final CountDownLatch end = new CountDownLatch(1);
  private final CountDownLatch interrupted = new CountDownLatch(1);

  @AfterEach
  void goOn() {
    end.countDown();
  }

  private Outcome beSilent() throws InterruptedException {
    end.await();
    return STOPPED;
  }

  /** As a connection that is not interruptible. */
  private Outcome ignoreInterrupts() {
    boolean isOver = false;
    while (!isOver) {
      try {
        end.await();
        isOver = true;
      } catch (InterruptedException e) { // it goes on
        interrupted.countDown();
      }
    }
    return STOPPED;
  }

  private static void callMany(FairCallScheduler calls, int count, Callable<Outcome> code) {
    for (int i = 0; i < count; i++) {
      CompletableFuture<Outcome> unused = calls.call(STRANGERS, null, "fake" + i, code);
    }
  }

  @Test
  void oneLookupServiceDoesNotTakeEveryPlace() throws Exception {
    FairCallScheduler.Limits noneLeaves = new FairCallScheduler.Limits(4, 3, 100, 1, LONG, LONG);
    try (FairCallScheduler calls = new FairCallScheduler(noneLeaves, LONG)) {
      callMany(calls, 500, this::beSilent);
      assertThat(calls.call(HONEST, null, "atrv1", () -> STOPPED).get(20, TimeUnit.SECONDS))
          .isEqualTo(STOPPED);
    }
  }

  @Test
  void aSilentCallLeavesItsPlaceAndItsAnswerStillCounts() throws Exception {
    FairCallScheduler.Limits one = new FairCallScheduler.Limits(1, 1, 100, 1, BRIEF, LONG);
    try (FairCallScheduler calls = new FairCallScheduler(one, LONG)) {
      CompletableFuture<Outcome> late = calls.call(HONEST, null, "atrv1", this::beSilent);
      assertThat(calls.call(HONEST, null, "atrv1", () -> STOPPED).get(20, TimeUnit.SECONDS))
          .isEqualTo(STOPPED);
      assertThat(late).isNotDone();
      end.countDown();
      assertThat(late.get(20, TimeUnit.SECONDS)).isEqualTo(STOPPED);
    }
  }

  @Test
  void robotsOfOneLookupServiceAreCalledRoundRobin() throws Exception {
    FairCallScheduler.Limits one = new FairCallScheduler.Limits(1, 1, 100, 1, LONG, LONG);
    CountDownLatch first = new CountDownLatch(1);
    try (FairCallScheduler calls = new FairCallScheduler(one, LONG)) {
      CompletableFuture<Outcome> begun =
          calls.call(
              STRANGERS,
              null,
              "fake",
              () -> {
                first.await();
                return STOPPED;
              });
      CompletableFuture<Outcome> second = calls.call(STRANGERS, null, "fake", () -> STOPPED);
      CompletableFuture<Outcome> third = calls.call(STRANGERS, null, "fake", this::beSilent);
      CompletableFuture<Outcome> honest = calls.call(STRANGERS, null, "atrv1", () -> STOPPED);
      first.countDown();
      assertThat(honest.get(20, TimeUnit.SECONDS)).isEqualTo(STOPPED);
      assertThat(begun).isDone();
      assertThat(second).isDone();
      assertThat(third).as("behind them").isNotDone();
    }
  }

  @Test
  void aCallThatIsNotAnsweredInTimeIsInterrupted() throws Exception {
    try (FairCallScheduler calls = new FairCallScheduler(FairCallScheduler.Limits.DEFAULT, BRIEF)) {
      CompletableFuture<Outcome> answer =
          calls.call(STRANGERS, null, "fake", this::ignoreInterrupts);
      assertThatThrownBy(() -> answer.get(20, TimeUnit.SECONDS))
          .isInstanceOf(ExecutionException.class)
          .hasCauseInstanceOf(TimeoutException.class);
      assertThat(interrupted.await(20, TimeUnit.SECONDS)).isTrue();
    }
  }

  @Test
  void callsThatNeverEndKeepNoOtherLookupServiceWaiting() throws Exception {
    FairCallScheduler.Limits few =
        new FairCallScheduler.Limits(100, 100, 5, 1, BRIEF, Duration.ofSeconds(1));
    try (FairCallScheduler calls = new FairCallScheduler(few, LONG)) {
      callMany(calls, 5, this::beSilent);
      CompletableFuture<Outcome> sixth = calls.call(STRANGERS, null, "fake6", this::beSilent);
      assertThat(calls.call(HONEST, null, "atrv1", () -> STOPPED).get(20, TimeUnit.SECONDS))
          .isEqualTo(STOPPED);
      assertThatThrownBy(() -> sixth.get(20, TimeUnit.SECONDS))
          .isInstanceOf(ExecutionException.class)
          .cause()
          .isInstanceOf(FairCallScheduler.NotCalledException.class)
          .hasMessage("it was not called within 1.0 s: 5 other calls do not end");
    }
  }

  /** One after the other they would take twice the patience of this test. */
  @Test
  void silentProxiesOfOneHostWaitForOneAnotherOnly() throws Exception {
    FairCallScheduler.Limits one = new FairCallScheduler.Limits(1, 1, 5000, 1, BRIEF, LONG);
    try (FairCallScheduler calls = new FairCallScheduler(one, LONG);
        ServerSocket strangers = new ServerSocket(0, 5000, InetAddress.getByName("127.0.0.2"));
        ServerSocket robot = new ServerSocket(0, 50, InetAddress.getByName("127.0.0.1"))) {
      for (int i = 0; i < 2000; i++) {
        CompletableFuture<Outcome> unused =
            calls.call(STRANGERS, address(strangers), "fake" + i, this::beSilent);
      }
      assertThat(
              calls
                  .call(STRANGERS, address(robot), "atrv1", () -> STOPPED)
                  .get(20, TimeUnit.SECONDS))
          .isEqualTo(STOPPED);
    }
  }

  /** As above, and each names another host, which answers no connection attempt. */
  @Test
  void proxiesThatNameUnreachableHostsWaitForTheOthers() throws Exception {
    Duration half = Duration.ofMillis(500);
    FairCallScheduler.Limits one = new FairCallScheduler.Limits(1, 1, 5000, 1, half, LONG);
    List<UnreachablePeer> strangers = new ArrayList<>();
    try (FairCallScheduler calls = new FairCallScheduler(one, LONG);
        ServerSocket robot = new ServerSocket(0, 50, InetAddress.getByName("127.0.0.1"))) {
      for (int i = 1; i <= 80; i++) {
        UnreachablePeer stranger = UnreachablePeer.open("127.0.7." + i);
        strangers.add(stranger);
        CompletableFuture<Outcome> unused =
            calls.call(STRANGERS, stranger.address(), "fake" + i, this::beSilent);
      }
      assertThat(
              calls
                  .call(STRANGERS, address(robot), "atrv1", () -> STOPPED)
                  .get(20, TimeUnit.SECONDS))
          .isEqualTo(STOPPED);
    } finally {
      for (UnreachablePeer each : strangers) {
        each.close();
      }
    }
  }

  private static PeerAddress address(ServerSocket socket) {
    return new PeerAddress(socket.getInetAddress().getHostAddress(), socket.getLocalPort());
  }
}
