package org.dfra.river.phoenix;

import static org.assertj.core.api.Assertions.assertThat;

import java.rmi.ConnectException;
import java.rmi.RemoteException;
import java.rmi.activation.ActivationID;
import java.rmi.server.UID;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import org.dfra.river.fixture.SteppedTime;
import org.junit.jupiter.api.Test;

/** Only what was ready for long enough without interruption has worked. */
class ReadinessReporterTest {

  private final SteppedTime time = new SteppedTime();
  private final FakeMonitor monitor = new FakeMonitor();
  private final ReadinessReporter reports = new ReadinessReporter(() -> monitor, time::nanos);
  private final ActivationID module = new JeriActivationID((id, force) -> null, new UID());
  private volatile boolean isReady;

  /** Wants 2 s, as the usual policy does. */
  private static final class FakeMonitor implements ReadinessMonitor {
    final List<ActivationID> worked = new ArrayList<>();
    boolean answers = true;

    @Override
    public long minReadyMillis() throws RemoteException {
      if (!answers) {
        throw new ConnectException("phoenix is being started again");
      }
      return 2000;
    }

    @Override
    public void reportStable(ActivationID id, long incarnation) {
      worked.add(id);
    }
  }

  /** Time passes, and it is looked after each tenth of a second. */
  private void pass(long millis) {
    for (long passed = 0; passed < millis; passed += 100) {
      time.pass(Duration.ofMillis(100));
      boolean unused = reports.poll();
    }
  }

  @Test
  void oneThatWasReadyForAMomentAndFailedHasNotWorked() {
    reports.track(module, () -> isReady);
    pass(100);
    isReady = true;
    pass(200);
    isReady = false;
    pass(60_000);
    assertThat(monitor.worked).isEmpty();
  }

  @Test
  void oneThatWasReadyForLongEnoughHasWorkedAndIsReportedOnce() {
    reports.track(module, () -> isReady);
    isReady = true;
    pass(2000);
    assertThat(monitor.worked).isEmpty();
    pass(100);
    assertThat(monitor.worked).containsExactly(module);
    isReady = false; // whatever becomes of it
    pass(100);
    isReady = true;
    pass(10_000);
    assertThat(monitor.worked).containsExactly(module);
  }

  @Test
  void timesBetweenInterruptionsAreNotAddedUp() {
    reports.track(module, () -> isReady);
    for (int flap = 0; flap < 20; flap++) {
      isReady = true;
      pass(1500);
      isReady = false;
      pass(100);
    }
    assertThat(monitor.worked).isEmpty();
  }

  @Test
  void oneWhoseReadinessCannotBeAskedIsNotReady() {
    reports.track(
        module,
        () -> {
          if (!isReady) {
            throw new IllegalStateException("a driver's own");
          }
          return true;
        });
    isReady = true;
    pass(1500);
    isReady = false;
    pass(100);
    isReady = true;
    pass(1500);
    assertThat(monitor.worked).isEmpty();
  }

  @Test
  void aReportThatCannotBeMadeIsMadeLater() {
    reports.track(module, () -> true);
    monitor.answers = false;
    time.pass(Duration.ofSeconds(1));
    assertThat(reports.poll()).as("looks again soon").isFalse();
    pass(3000);
    monitor.answers = true;
    assertThat(reports.poll()).isTrue();
    assertThat(monitor.worked).containsExactly(module);
  }

  @Test
  void oneThatIsInactiveIsNotReported() {
    reports.track(module, () -> true);
    pass(1000);
    reports.inactive(module);
    pass(5000);
    assertThat(monitor.worked).isEmpty();
  }
}
