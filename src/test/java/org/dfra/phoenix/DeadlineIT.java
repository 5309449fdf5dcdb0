package org.dfra.phoenix;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;
import static org.awaitility.Awaitility.await;

import java.rmi.RemoteException;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import org.awaitility.core.ConditionFactory;
import org.dfra.river.call.DeadlineExceededException;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** Calls to a server that was stopped, as {@code kill -STOP} does, beside one that runs. */
class DeadlineIT {

  /** Of each call, milliseconds. */
  private static final long DEADLINE = 2000;

  /** What a busy machine may add to it before this is not told from waiting for ever. */
  private static final long SLOW_MACHINE = 15_000;

  private final ExecutorService threads = Executors.newCachedThreadPool();
  private RemoteBeacon silent;
  private RemoteBeacon living;

  @BeforeEach
  void start() throws Exception {
    silent = RemoteBeacon.start();
    living = RemoteBeacon.start();
    for (RemoteBeacon each : List.of(silent, living)) {
      patiently("answers").untilAsserted(() -> assertThat(each.proxy.pid()).isPositive());
    }
  }

  /** Calls again where a machine that stands still let a call miss its deadline. */
  private static ConditionFactory patiently(String what) {
    return await(what)
        .atMost(PhoenixFixture.PATIENCE)
        .ignoreExceptionsInstanceOf(RemoteException.class);
  }

  @AfterEach
  void end() throws Exception {
    threads.shutdownNow();
    silent.close();
    living.close();
  }

  @Test
  void stoppedServerIsReportedInTimeBlocksNobodyAndWorksAgain() throws Exception {
    silent.signal("STOP");
    long began = System.nanoTime();
    List<Future<Long>> stuck = new ArrayList<>();
    for (int i = 0; i < 4; i++) {
      stuck.add(threads.submit(() -> silent.proxy.pid()));
    }
    int answered = 0;
    while (!stuck.stream().allMatch(Future::isDone)) {
      answered += isAnswered(living) ? 1 : 0;
    }
    assertThat(millisSince(began))
        .as("ms until the stopped server was reported")
        .isBetween(DEADLINE - 100, SLOW_MACHINE);
    assertThat(answered).as("calls to the other one meanwhile").isGreaterThan(20);
    for (Future<Long> each : stuck) {
      assertThatExceptionOfType(java.util.concurrent.ExecutionException.class)
          .isThrownBy(each::get)
          .withCauseInstanceOf(DeadlineExceededException.class)
          .withMessageContaining("Beacon.pid on TcpEndpoint")
          .withMessageContaining("got no answer within 2000 ms; it may have run");
    }
    silent.signal("CONT");
    patiently("the server answers again")
        .untilAsserted(() -> assertThat(silent.proxy.pid()).isEqualTo(silent.process.pid()));
  }

  @Test
  void loadTooBigForTheSocketsOfAStoppedServerIsGivenUpInTime() throws Exception {
    silent.signal("STOP");
    long began = System.nanoTime();
    assertThatExceptionOfType(DeadlineExceededException.class)
        .isThrownBy(() -> silent.proxy.length(new byte[16 << 20]));
    assertThat(millisSince(began)).as("ms").isBetween(DEADLINE - 100, SLOW_MACHINE);
    patiently("the other one takes loads")
        .untilAsserted(() -> assertThat(living.proxy.length(new byte[1 << 20])).isEqualTo(1 << 20));
    silent.signal("CONT");
    patiently("the server answers again")
        .untilAsserted(() -> assertThat(silent.proxy.pid()).isEqualTo(silent.process.pid()));
  }

  @Test
  void killedServerIsReportedAtOnce() throws Exception {
    silent.close();
    long began = System.nanoTime();
    assertThatExceptionOfType(RemoteException.class).isThrownBy(() -> silent.proxy.pid());
    assertThat(millisSince(began)).as("ms").isLessThan(SLOW_MACHINE);
  }

  private static boolean isAnswered(RemoteBeacon beacon) {
    try {
      return beacon.proxy.pid() > 0;
    } catch (RemoteException e) {
      return false; // a machine that stands still lets a call miss its deadline
    }
  }

  private static long millisSince(long nanos) {
    return (System.nanoTime() - nanos) / 1_000_000;
  }
}
