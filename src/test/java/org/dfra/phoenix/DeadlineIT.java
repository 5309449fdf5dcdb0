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
import org.awaitility.core.ConditionFactory;
import org.dfra.core.time.StallProbe;
import org.dfra.core.time.Timing;
import org.dfra.river.call.DeadlineExceededException;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.MethodOrderer;
import org.junit.jupiter.api.Order;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestMethodOrder;

/**
 * Calls to a server that was stopped, as {@code kill -STOP} does, beside one that runs. The tests
 * share the two; the last one kills one of them.
 */
@TestMethodOrder(MethodOrderer.OrderAnnotation.class)
class DeadlineIT {

  /** Of each call. */
  private static final Duration DEADLINE = Duration.ofSeconds(2);

  /** The requirement for the report of a silent peer. */
  private static final Duration REPORTED = Duration.ofSeconds(3);

  private final StallProbe probe = StallProbe.start();

  private final ExecutorService threads = Executors.newCachedThreadPool();
  private static RemoteBeacon silent;
  private static RemoteBeacon living;

  @BeforeAll
  static void start() throws Exception {
    silent = RemoteBeacon.start();
    living = RemoteBeacon.start();
  }

  @BeforeEach
  void awaitBoth() throws Exception {
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
    probe.close();
    threads.shutdownNow();
    if (silent.process.isAlive()) {
      silent.signal("CONT"); // also where a test has failed
    }
  }

  @AfterAll
  static void endBoth() throws Exception {
    try (RemoteBeacon one = silent;
        RemoteBeacon other = living) {
      assertThat(one == null).isEqualTo(other == null);
    }
  }

  @Test
  void stoppedServerIsReportedInTimeBlocksNobodyAndWorksAgain() throws Exception {
    silent.signal("STOP");
    StallProbe.Stopwatch began = probe.stopwatch();
    List<Future<Long>> stuck = new ArrayList<>();
    for (int i = 0; i < 4; i++) {
      stuck.add(threads.submit(() -> silent.proxy.pid()));
    }
    int answered = 0;
    Timing slowest = probe.stopwatch().stop();
    while (!stuck.stream().allMatch(Future::isDone)) {
      StallProbe.Stopwatch asked = probe.stopwatch();
      answered += isAnswered(living) ? 1 : 0;
      Timing call = asked.stop();
      slowest = call.took().compareTo(slowest.took()) > 0 ? call : slowest;
    }
    Timing reported = began.stop();
    assertThat(reported.took()).isGreaterThan(DEADLINE.minusMillis(100));
    assertThat(answered).as("calls to the other one meanwhile").isGreaterThan(20);
    for (Future<Long> each : stuck) {
      assertThatExceptionOfType(java.util.concurrent.ExecutionException.class)
          .isThrownBy(each::get)
          .withCauseInstanceOf(DeadlineExceededException.class)
          .withMessageContaining("Beacon.pid on 127.0.0.1:")
          .withMessageContaining("got no answer within 2000 ms; it "); // may have run, or has not
    }
    silent.signal("CONT");
    patiently("the server answers again")
        .untilAsserted(() -> assertThat(silent.proxy.pid()).isEqualTo(silent.process.pid()));
    reported.requireWithin("the report of a stopped server", REPORTED);
    slowest.requireWithin("the slowest call to another server", Duration.ofSeconds(1));
  }

  @Test
  void loadTooBigForTheSocketsOfAStoppedServerIsGivenUpInTime() throws Exception {
    silent.signal("STOP");
    StallProbe.Stopwatch began = probe.stopwatch();
    assertThatExceptionOfType(DeadlineExceededException.class)
        .isThrownBy(() -> silent.proxy.length(new byte[16 << 20]));
    Timing reported = began.stop();
    assertThat(reported.took()).isGreaterThan(DEADLINE.minusMillis(100));
    patiently("the other one takes loads")
        .untilAsserted(() -> assertThat(living.proxy.length(new byte[1 << 20])).isEqualTo(1 << 20));
    silent.signal("CONT");
    patiently("the server answers again")
        .untilAsserted(() -> assertThat(silent.proxy.pid()).isEqualTo(silent.process.pid()));
    reported.requireWithin("the report of a stopped server that takes a load", REPORTED);
  }

  @Test
  @Order(Integer.MAX_VALUE) // it ends one of the servers
  void killedServerIsReportedAtOnce() throws Exception {
    silent.close();
    StallProbe.Stopwatch began = probe.stopwatch();
    assertThatExceptionOfType(RemoteException.class).isThrownBy(() -> silent.proxy.pid());
    began.stop().requireWithin("the report of a killed server", Duration.ofMillis(1500));
  }

  private static boolean isAnswered(RemoteBeacon beacon) {
    try {
      return beacon.proxy.pid() > 0;
    } catch (RemoteException e) {
      return false; // a machine that stands still lets a call miss its deadline
    }
  }
}
