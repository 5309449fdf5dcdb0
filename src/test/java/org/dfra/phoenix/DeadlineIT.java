package org.dfra.phoenix;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;
import static org.awaitility.Awaitility.await;

import java.rmi.RemoteException;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import org.dfra.river.call.DeadlineExceededException;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** Calls to a server that was stopped, as {@code kill -STOP} does, beside one that runs. */
class DeadlineIT {

  private final ExecutorService threads = Executors.newCachedThreadPool();
  private RemoteBeacon silent;
  private RemoteBeacon living;

  @BeforeEach
  void start() throws Exception {
    silent = RemoteBeacon.start();
    living = RemoteBeacon.start();
    silent.proxy.pid();
    living.proxy.pid();
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
    long slowest = 0;
    while (!stuck.stream().allMatch(Future::isDone)) {
      long before = System.nanoTime();
      living.proxy.pid();
      slowest = Math.max(slowest, System.nanoTime() - before);
    }
    assertThat(millisSince(began))
        .as("ms until the stopped server was reported")
        .isBetween(1900L, 3000L);
    assertThat(slowest / 1_000_000).as("ms of the slowest call to the other one").isLessThan(1000);
    for (Future<Long> each : stuck) {
      assertThatExceptionOfType(java.util.concurrent.ExecutionException.class)
          .isThrownBy(each::get)
          .withCauseInstanceOf(DeadlineExceededException.class)
          .withMessageContaining("Beacon.pid on TcpEndpoint")
          .withMessageContaining("got no answer within 2000 ms; it may have run");
    }
    silent.signal("CONT");
    await("the server answers again")
        .atMost(Duration.ofSeconds(15))
        .ignoreExceptionsInstanceOf(RemoteException.class)
        .untilAsserted(() -> assertThat(silent.proxy.pid()).isEqualTo(silent.process.pid()));
  }

  @Test
  void loadTooBigForTheSocketsOfAStoppedServerIsGivenUpInTime() throws Exception {
    silent.signal("STOP");
    long began = System.nanoTime();
    assertThatExceptionOfType(DeadlineExceededException.class)
        .isThrownBy(() -> silent.proxy.length(new byte[16 << 20]));
    assertThat(millisSince(began)).as("ms").isBetween(1900L, 3000L);
    assertThat(living.proxy.length(new byte[1 << 20])).isEqualTo(1 << 20);
    silent.signal("CONT");
    await("the server answers again")
        .atMost(Duration.ofSeconds(15))
        .ignoreExceptionsInstanceOf(RemoteException.class)
        .untilAsserted(() -> assertThat(silent.proxy.pid()).isEqualTo(silent.process.pid()));
  }

  @Test
  void killedServerIsReportedAtOnce() throws Exception {
    silent.close();
    long began = System.nanoTime();
    assertThatExceptionOfType(RemoteException.class).isThrownBy(() -> silent.proxy.pid());
    assertThat(millisSince(began)).as("ms").isLessThan(1500);
  }

  private static long millisSince(long nanos) {
    return (System.nanoTime() - nanos) / 1_000_000;
  }
}
