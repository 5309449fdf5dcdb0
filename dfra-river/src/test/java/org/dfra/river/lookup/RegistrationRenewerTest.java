package org.dfra.river.lookup;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;

import java.rmi.RemoteException;
import java.time.Duration;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import net.jini.core.lease.Lease;
import net.jini.core.lease.UnknownLeaseException;
import net.jini.lease.LeaseRenewalEvent;
import org.dfra.river.fixture.FakeLease;
import org.dfra.river.fixture.SteppedTime;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** Registrations are renewed in time, however the computer's clock is set. */
@Timeout(60)
class RegistrationRenewerTest {

  private static final long LEASE = 30_000;
  private static final long HOUR = Duration.ofHours(1).toMillis();

  private final SteppedTime time = new SteppedTime();
  private final RegistrationRenewer renewals = new RegistrationRenewer(new LeaseBatches(time));
  private final FakeLease lease = new FakeLease(LEASE);
  private final BlockingQueue<LeaseRenewalEvent> ended = new LinkedBlockingQueue<>();

  private void begin() {
    renewals.renewUntil(lease, Lease.FOREVER, LEASE, ended::add);
  }

  private void awaitRenewal() throws InterruptedException {
    assertThat(lease.renewed.poll(30, TimeUnit.SECONDS)).as("renewed for").isEqualTo(LEASE);
  }

  /** Renewals are made by other threads: the next one is timed when the last has returned. */
  private void awaitNextIsTimed() throws InterruptedException {
    CountDownLatch never = new CountDownLatch(1);
    while (time.waiting() == 0 && ended.isEmpty()) {
      assertThat(never.await(1, TimeUnit.MILLISECONDS)).isFalse();
    }
  }

  @Test
  void isRenewedWhenAThirdIsOverWhateverTheClockSays() throws Exception {
    begin();
    for (long step : new long[] {0, -HOUR, HOUR, -100_000, 0}) {
      lease.clockIsSet(step);
      time.pass(Duration.ofMillis(LEASE / 3 - 100));
      assertThat(lease.renewed).as("too early, after a step of %d ms", step).isEmpty();
      time.pass(Duration.ofMillis(100));
      awaitRenewal();
      awaitNextIsTimed();
    }
    assertThat(ended).isEmpty();
  }

  @Test
  void aLeaseThatIsUnknownIsReportedAtOnceSoThatTheModuleIsRegisteredAgain() throws Exception {
    begin();
    lease.forget();
    time.pass(Duration.ofSeconds(10));
    LeaseRenewalEvent event = ended.poll(30, TimeUnit.SECONDS);
    assertThat(event.getLease()).isSameAs(lease);
    assertThat(event.getException()).isInstanceOf(UnknownLeaseException.class);
    assertThat(time.waiting()).as("renewals to come").isZero();
  }

  @Test
  void anUnreachableRegistrarIsTriedAgainUntilTheLeaseIsOver() throws Exception {
    begin();
    lease.failsBy(new RemoteException("no way there"));
    int tries = 0;
    while (ended.isEmpty()) {
      time.pass(Duration.ofSeconds(1));
      if (lease.renewed.poll(20, TimeUnit.MILLISECONDS) != null) {
        tries++;
        awaitNextIsTimed();
      }
      assertThat(time.nanos()).as("time").isLessThan(Duration.ofMinutes(1).toNanos());
    }
    assertThat(tries).as("tries").isGreaterThan(5);
    assertThat(time.nanos()).isGreaterThanOrEqualTo(Duration.ofSeconds(30).toNanos());
    assertThat(ended.take().getException()).hasMessage("no way there");
  }

  @Test
  void whatIsRemovedIsRenewedNoMoreAndWhatComesTooLateIsCancelled() throws Exception {
    begin();
    renewals.remove(lease);
    assertThatExceptionOfType(UnknownLeaseException.class).isThrownBy(() -> renewals.remove(lease));
    time.pass(Duration.ofMinutes(1));
    assertThat(lease.renewed).isEmpty();
    renewals.close();
    FakeLease late = new FakeLease(LEASE);
    renewals.renewUntil(late, Lease.FOREVER, LEASE, ended::add);
    assertThatExceptionOfType(UnknownLeaseException.class)
        .as("it is cancelled")
        .isThrownBy(() -> late.renew(LEASE));
  }
}
