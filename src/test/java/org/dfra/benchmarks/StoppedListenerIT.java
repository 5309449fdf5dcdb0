package org.dfra.benchmarks;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import java.time.Duration;
import java.util.List;
import java.util.stream.LongStream;
import org.dfra.benchmarks.event.BenchSensor;
import org.dfra.river.server.sensor.GPSServer;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** What the benchmark of events measures, without its clock: nobody misses anything. */
@Timeout(120)
class StoppedListenerIT {

  private static final Duration PATIENCE = Duration.ofSeconds(60);
  private static final int EVENTS = 40; // a listener keeps 50

  @Test
  void othersReceiveEverythingWhileOneListeningProcessIsStopped() throws Exception {
    try (BenchRegistrar reggie = new BenchRegistrar(30_000);
        GPSServer server = BenchSensor.serve(List.of(reggie.locator()));
        ListenerProcess stopped = new ListenerProcess(reggie.locator());
        ListenerProcess second = new ListenerProcess(reggie.locator());
        ListenerProcess third = new ListenerProcess(reggie.locator())) {
      List<ListenerProcess> others = List.of(second, third);
      BenchSensor sensor = BenchSensor.awaitInstance();
      for (ListenerProcess each : List.of(stopped, second, third)) {
        each.awaitReady();
        each.checkClock();
      }
      sensor.publish();
      await().atMost(PATIENCE).until(() -> stopped.report().size() == 1);

      stopped.signal("STOP");
      try {
        for (int i = 1; i < EVENTS; i++) {
          sensor.publish();
        }
        for (ListenerProcess each : others) {
          await().atMost(PATIENCE).until(() -> each.report().size() == EVENTS);
          assertThat(each.report().keySet())
              .containsExactlyInAnyOrderElementsOf(
                  LongStream.rangeClosed(1, EVENTS).boxed().toList());
        }
      } finally {
        stopped.signal("CONT");
      }
      // Given up meanwhile or not, it receives what comes now: numbers above those sent before.
      await()
          .atMost(PATIENCE)
          .until(
              () -> {
                sensor.publish();
                return stopped.report().keySet().stream().anyMatch(number -> number > EVENTS);
              });
      assertThat(server.identification().path()).isEqualTo("bench/gps");
    }
  }

  /** A delivery that succeeds renews the lease; to a process that is stopped none does. */
  @Test
  void aStoppedProcessLosesItsLeaseWhileEventsAreSentToIt() throws Exception {
    try (BenchRegistrar reggie = new BenchRegistrar(30_000);
        GPSServer server = BenchSensor.serve(List.of(reggie.locator()));
        ListenerProcess stopped = new ListenerProcess(reggie.locator());
        ListenerProcess other = new ListenerProcess(reggie.locator())) {
      BenchSensor sensor = BenchSensor.awaitInstance();
      stopped.awaitReady();
      other.awaitReady();
      assertThat(sensor.leases().clients()).isEqualTo(2);
      stopped.signal("STOP");
      try {
        await()
            .atMost(PATIENCE)
            .until(
                () -> {
                  sensor.publish();
                  return sensor.leases().clients() == 1;
                });
      } finally {
        stopped.signal("CONT");
      }
      await("it registers again").atMost(PATIENCE).until(() -> sensor.leases().clients() == 2);
      assertThat(server.identification().path()).isEqualTo("bench/gps");
    }
  }
}
