package org.dfra.cli.stop;

import java.time.Duration;
import java.time.Instant;
import java.util.UUID;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.LinkedBlockingQueue;
import org.dfra.cli.stop.Outcome.Result;
import org.dfra.cli.stop.PhoenixAddresses.Address;
import org.dfra.flow.effector.EmergencyStopState;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Timeout;

/** A round of calls that are answered as the test says, or not before it ends. */
@Timeout(60)
abstract class StopDispatcherFixture {

  static final Instant NOON = Instant.parse("2026-11-21T12:00:00Z");
  static final UUID REGISTRAR = UUID.randomUUID();
  static final Address ROBOT = new Address("192.0.2.7", 1198);
  static final Duration RUNNING = Duration.ofSeconds(2);
  static final EmergencyStopState STOPPED = stopped(Duration.ofSeconds(1), true, null);

  final BlockingQueue<Outcome> well = new LinkedBlockingQueue<>();
  final CountDownLatch end = new CountDownLatch(1);
  final StopMerge merge = new StopMerge("the test", () -> RUNNING);
  final StopDispatcher round =
      new StopDispatcher(Result.NOT_STOPPED, Duration.ofSeconds(20), () -> false, well::add, merge);

  @BeforeEach
  void findRegistrar() {
    round.registrarFound(REGISTRAR, ROBOT.host());
  }

  @AfterEach
  void close() {
    end.countDown();
    round.close();
  }

  static Outcome stopped(String path) {
    return Outcome.ofStop(path, RUNNING, STOPPED);
  }

  static EmergencyStopState stopped(Duration age, boolean resting, @Nullable String fault) {
    return new EmergencyStopState(true, "ops", NOON, resting, fault, age);
  }

  Outcome beSilent() throws InterruptedException {
    end.await();
    return stopped("too late");
  }
}
