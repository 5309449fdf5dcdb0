package org.dfra.river.proxy;

import static org.assertj.core.api.Assertions.assertThat;

import com.sun.jini.landlord.Landlord;
import java.rmi.RemoteException;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import net.jini.core.lease.UnknownLeaseException;
import net.jini.id.Uuid;
import net.jini.id.UuidFactory;
import org.dfra.river.fixture.SteppedTime;
import org.dfra.river.remote.LeaseRevokedException;
import org.dfra.river.remote.ProcessLease;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

/** Leases of one landlord are renewed by one call; each has its own result. */
class JointRenewalTest {

  private static final Duration PERIOD = Duration.ofMillis(800);
  private static final long LEASE_MILLIS = 10_000;

  /** Records the calls, each as the set of leases that it names. */
  private static final class RecordingLandlord implements Landlord {
    final List<Set<Uuid>> calls = new ArrayList<>();
    final Set<Uuid> forgotten = new HashSet<>();
    final Set<Uuid> revoked = new HashSet<>();
    @Nullable RemoteException failure;

    @Override
    public long renew(Uuid cookie, long duration) throws UnknownLeaseException, RemoteException {
      calls.add(Set.of(cookie));
      throwIfSilent();
      if (forgotten.contains(cookie)) {
        throw new UnknownLeaseException("forgotten");
      }
      return duration;
    }

    @Override
    public RenewResults renewAll(Uuid[] cookies, long[] durations) throws RemoteException {
      calls.add(Set.of(cookies));
      throwIfSilent();
      long[] granted = durations.clone();
      List<Exception> denied = new ArrayList<>();
      for (int i = 0; i < cookies.length; i++) {
        if (forgotten.contains(cookies[i])) {
          granted[i] = -1;
          denied.add(new UnknownLeaseException("forgotten"));
        } else if (revoked.contains(cookies[i])) {
          granted[i] = -1;
          denied.add(new LeaseRevokedException("revoked"));
        }
      }
      return denied.isEmpty()
          ? new RenewResults(granted)
          : new RenewResults(granted, denied.toArray(Exception[]::new));
    }

    private void throwIfSilent() throws RemoteException {
      if (failure != null) {
        throw failure;
      }
    }

    @Override
    public void cancel(Uuid cookie) {}

    @Override
    @SuppressWarnings("rawtypes") // as River declares it
    public @Nullable Map cancelAll(Uuid[] cookies) {
      return null;
    }
  }

  private final SteppedTime time = new SteppedTime();
  private final RecordingLandlord landlord = new RecordingLandlord();
  private final List<LeaseRenewer> open = new ArrayList<>();

  private record Held(LeaseRenewer renewer, Uuid id) {}

  private Held hold(Landlord of) {
    Uuid id = UuidFactory.generate();
    ProcessLease lease = new ProcessLease(id, of, System.currentTimeMillis() + LEASE_MILLIS);
    LeaseRenewer renewer = new LeaseRenewer("a lease", LEASE_MILLIS, lease, time, Runnable::run);
    open.add(renewer);
    renewer.start();
    return new Held(renewer, id);
  }

  @AfterEach
  void close() {
    open.forEach(LeaseRenewer::close);
  }

  @Test
  void leasesThatAreDueWithinHalfAPeriodGoInOneCallForEver() {
    Held first = hold(landlord);
    time.pass(Duration.ofMillis(100));
    Held second = hold(landlord);
    time.pass(Duration.ofMillis(300));
    Held third = hold(landlord);
    time.pass(PERIOD.multipliedBy(10));
    assertThat(landlord.calls).hasSizeBetween(9, 11);
    assertThat(landlord.calls).containsOnly(Set.of(first.id(), second.id(), third.id()));
    assertThat(first.renewer().isLive() && third.renewer().isLive()).isTrue();
  }

  @Test
  void aLeaseThatIsNotDueSoonIsNotInTheCall() {
    Held first = hold(landlord);
    time.pass(Duration.ofMillis(500));
    Held second = hold(landlord);
    time.pass(Duration.ofMillis(300));
    assertThat(landlord.calls).containsExactly(Set.of(first.id()));
    time.pass(Duration.ofMillis(500));
    assertThat(landlord.calls)
        .as("the second takes the first along")
        .containsExactly(Set.of(first.id()), Set.of(first.id(), second.id()));
  }

  @Test
  void leasesOfAnotherLandlordAreNotInTheCall() {
    RecordingLandlord other = new RecordingLandlord();
    Held first = hold(landlord);
    Held second = hold(other);
    time.pass(PERIOD);
    assertThat(landlord.calls).containsExactly(Set.of(first.id()));
    assertThat(other.calls).containsExactly(Set.of(second.id()));
  }

  @Test
  void eachLeaseHasItsOwnResult() {
    Held good = hold(landlord);
    Held lost = hold(landlord);
    Held taken = hold(landlord);
    landlord.forgotten.add(lost.id());
    landlord.revoked.add(taken.id());
    time.pass(PERIOD);
    assertThat(landlord.calls).hasSize(1);
    assertThat(good.renewer().isLive()).isTrue();
    assertThat(lost.renewer().isClosed()).as("a lost one of this kind does not come back").isTrue();
    assertThat(taken.renewer().isClosed()).isTrue();
    time.pass(PERIOD);
    assertThat(landlord.calls.get(1)).isEqualTo(Set.of(good.id()));
  }

  @Test
  void aCallThatFailsIsAnInterruptionOfEachAndTheNextIsOneCallAgain() {
    Held first = hold(landlord);
    Held second = hold(landlord);
    landlord.failure = new RemoteException("no answer");
    time.pass(PERIOD);
    for (Held each : Arrays.asList(first, second)) {
      assertThat(each.renewer().interruptedSince()).isPresent();
      assertThat(each.renewer().isLive()).isTrue();
    }
    landlord.failure = null;
    time.pass(Duration.ofMillis(100));
    assertThat(landlord.calls).hasSize(2).containsOnly(Set.of(first.id(), second.id()));
    assertThat(first.renewer().interruptedSince()).isEmpty();
    assertThat(second.renewer().interruptedSince()).isEmpty();
  }

  @Test
  void aLeaseThatIsClosedIsRenewedNoMore() {
    Held first = hold(landlord);
    Held second = hold(landlord);
    second.renewer().close();
    time.pass(PERIOD);
    assertThat(landlord.calls).containsExactly(Set.of(first.id()));
  }

  @Test
  void aLeaseThatDeliveriesRenewIsNotInTheCall() {
    Held first = hold(landlord);
    Held second = hold(landlord);
    time.pass(PERIOD.minusMillis(1));
    second.renewer().renewedByPeer(time.nanos());
    time.pass(Duration.ofMillis(1));
    assertThat(landlord.calls).containsExactly(Set.of(first.id()));
  }
}
