package org.dfra.river.server;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalStateException;
import static org.awaitility.Awaitility.await;

import java.rmi.RemoteException;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.UUID;
import java.util.concurrent.CountDownLatch;
import org.dfra.module.Diagnosable;
import org.dfra.module.Diagnosis;
import org.dfra.module.Precondition;
import org.dfra.river.remote.RemoteDiagnostics.DiagnosticType;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** A client that starts tests all the time does not get a thread for each. */
@Timeout(60)
class DiagnosticRunnerTest {

  private static final int MOST = 4;
  private static final Duration PATIENCE = Duration.ofSeconds(30);

  private final CountDownLatch release = new CountDownLatch(1);
  private final DiagnosticRunner runs = new DiagnosticRunner("atrv1/gps", new Slow());

  /** Its tests end when the test says so. */
  private final class Slow implements Diagnosable {
    @Override
    public List<Precondition> preconditions() {
      return List.of();
    }

    @Override
    public List<String> tests() {
      return List.of("slow");
    }

    @Override
    public Diagnosis test(String name) throws RemoteException {
      try {
        release.await();
      } catch (InterruptedException e) {
        throw new RemoteException("interrupted", e);
      }
      return new Diagnosis(name, true, "it was slow", Instant.EPOCH, Duration.ofSeconds(1));
    }

    @Override
    public List<String> recoveries() {
      return List.of();
    }

    @Override
    public Diagnosis recover(String name) {
      throw new IllegalArgumentException("no such recovery");
    }
  }

  @Test
  void aFewRunAtOnceAndOneMoreIsRefusedUntilOneHasEnded() throws Exception {
    List<UUID> begun = new ArrayList<>();
    for (int i = 0; i < MOST; i++) {
      begun.add(runs.startRun(DiagnosticType.TEST, "slow"));
    }
    assertThatIllegalStateException()
        .isThrownBy(() -> runs.startRun(DiagnosticType.TEST, "slow"))
        .withMessage(
            "atrv1/gps runs 4 tests and recoveries at once, and no more; begin \"slow\" when one"
                + " of them has ended");
    assertThat(runs.await(begun.get(0), Duration.ZERO)).as("still running").isNull();
    release.countDown();
    for (UUID each : begun) {
      assertThat(runs.await(each, PATIENCE)).isNotNull().matches(Diagnosis::passed, "passed");
    }
    await("their places are free").atMost(PATIENCE).until(this::begins);
  }

  private boolean begins() throws RemoteException {
    try {
      return runs.startRun(DiagnosticType.TEST, "slow") != null;
    } catch (IllegalStateException e) { // the last one's thread is about to end
      return false;
    }
  }
}
