package org.dfra.river.proxy;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import java.rmi.RemoteException;
import java.time.Duration;
import java.util.concurrent.Executor;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import org.dfra.river.fixture.FakeLease;
import org.dfra.river.fixture.SteppedTime;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** A lease on a module elsewhere lasts as long as it was granted, however the clock is set. */
@Timeout(60)
class LeaseRenewerTest {

  private static final Duration PATIENCE = Duration.ofSeconds(30);
  private static final Duration LEASE = Duration.ofSeconds(10);

  private final SteppedTime time = new SteppedTime();
  private final FakeLease lease = new FakeLease(LEASE.toMillis());
  private final LeaseRenewer command =
      new LeaseRenewer("command of r/drive", LEASE.toMillis(), lease, time);

  @ParameterizedTest
  @ValueSource(longs = {3_600_000, -3_600_000})
  void aClockThatIsSetEndsNoCommand(long step) throws Exception {
    command.start();
    lease.clockIsSet(step);
    assertThat(command.isLive()).as("after a step of %d ms", step).isTrue();
    assertThat(Duration.between(java.time.Instant.now(), command.expiration()))
        .isBetween(Duration.ofSeconds(-20), Duration.ofSeconds(11));
    time.pass(Duration.ofSeconds(1));
    assertThat(lease.renewed.poll(30, TimeUnit.SECONDS)).isEqualTo(LEASE.toMillis());
    await().atMost(PATIENCE).until(() -> time.waiting() == 1);
    assertThat(command.isLive()).isTrue();
    assertThat(command.isClosed()).isFalse();
  }

  @Test
  void aLeaseThatCannotBeRenewedIsOverInTimeAlsoWhereTheClockIsSetBack() {
    lease.failsBy(new RemoteException("no way there"));
    command.start();
    lease.clockIsSet(-3_600_000);
    for (int tries = 1; tries <= 12; tries++) { // every 0.8 s
      time.pass(Duration.ofMillis(800));
      await().atMost(PATIENCE).until(() -> time.waiting() == 1);
      assertThat(command.isLive()).as("after %d tries", tries).isTrue();
    }
    time.pass(Duration.ofMillis(400));
    assertThat(command.isLive()).as("10 s after it was granted").isFalse();
    command.close();
  }

  @Test
  void theFirstLeaseCountsFromItsRequestHoweverLateTheAnswerCame() {
    lease.failsBy(new RemoteException("no way there"));
    long asked = time.nanos();
    time.pass(Duration.ofMillis(1900)); // until the answer
    LeaseRenewer late =
        new LeaseRenewer("command of r/drive", LEASE.toMillis(), lease, time, Runnable::run)
            .requestedAt(asked);
    late.start();
    time.pass(Duration.ofMillis(8000));
    assertThat(late.isLive()).as("9.9 s after the request").isTrue();
    time.pass(Duration.ofMillis(200));
    assertThat(late.isLive()).as("10.1 s after the request").isFalse();
    late.close();
  }

  @Test
  void renewsAgainAfterThereWasNoThreadForIt() throws Exception {
    AtomicInteger missing = new AtomicInteger(2);
    Executor callers =
        task -> {
          if (missing.getAndDecrement() > 0) {
            throw new OutOfMemoryError("unable to create native thread");
          }
          task.run();
        };
    LeaseRenewer use =
        new LeaseRenewer("command of r/drive", LEASE.toMillis(), lease, time, callers);
    use.start();
    time.pass(Duration.ofMillis(3 * 800));
    assertThat(lease.renewed).containsExactly(LEASE.toMillis());
    time.pass(Duration.ofMillis(800));
    assertThat(lease.renewed).hasSize(2);
    use.close();
  }

  /** A server that is killed breaks off the call that is under way; the next brings it back. */
  @Test
  void asksAgainSoonAfterTheFirstFailureAndAtItsUsualPaceAfterTheNext() {
    AtomicInteger calls = new AtomicInteger();
    Executor callers =
        task -> {
          calls.incrementAndGet();
          task.run();
        };
    LeaseRenewer use = new LeaseRenewer("use of r/gps", LEASE.toMillis(), lease, time, callers);
    lease.failsBy(new RemoteException("broken off"));
    use.start();
    time.pass(Duration.ofMillis(800));
    assertThat(calls).hasValue(1);
    time.pass(Duration.ofMillis(100));
    assertThat(calls).hasValue(2);
    time.pass(Duration.ofMillis(700));
    assertThat(calls).hasValue(2);
    time.pass(Duration.ofMillis(100));
    assertThat(calls).hasValue(3);
    use.close();
  }

  /** As for a subscription to a module with ten readings a second. */
  @Test
  void noCallIsMadeWhileTheServerProvesThatItRenewsTheLease() {
    LeaseRenewer use = renewer();
    use.start();
    for (int i = 0; i < 100; i++) {
      time.pass(Duration.ofMillis(100));
      use.renewedByPeer(time.nanos() - Duration.ofMillis(100).toNanos());
    }
    assertThat(lease.renewed).isEmpty();
    assertThat(use.isLive()).as("after ten seconds").isTrue();
    time.pass(Duration.ofMillis(699));
    assertThat(lease.renewed).isEmpty();
    time.pass(Duration.ofMillis(1));
    assertThat(lease.renewed).as("0.8 s after the last proof").hasSize(1);
    use.close();
  }

  @Test
  void aProofProlongsTheLeaseFromItsOwnTimeAndNotFromItsArrival() {
    LeaseRenewer use = renewer();
    lease.failsBy(new RemoteException("no way there"));
    use.start();
    long early = time.nanos() + Duration.ofSeconds(2).toNanos();
    time.pass(Duration.ofSeconds(5));
    use.renewedByPeer(early);
    time.pass(Duration.ofSeconds(7).minusMillis(100));
    assertThat(use.isLive()).isTrue();
    time.pass(Duration.ofMillis(200));
    assertThat(use.isLive()).as("12 s after it was granted for 10").isFalse();
    use.renewedByPeer(time.nanos());
    assertThat(use.isLive()).as("a lease that may have ended is not revived").isFalse();
    use.close();
  }

  @Test
  void anInterruptedLeaseIsRenewedWhateverTheServerProves() {
    LeaseRenewer use = renewer();
    lease.failsBy(new RemoteException("no way there"));
    use.start();
    time.pass(Duration.ofMillis(800));
    lease.failsBy(null);
    use.renewedByPeer(time.nanos());
    time.pass(Duration.ofMillis(100));
    assertThat(lease.renewed).hasSize(2);
    assertThat(use.interruptedSince()).isEmpty();
    use.close();
  }

  private LeaseRenewer renewer() {
    return new LeaseRenewer("use of r/gps", LEASE.toMillis(), lease, time, Runnable::run);
  }
}
