package org.dfra.river.lookup;

import static org.assertj.core.api.Assertions.assertThat;

import com.sun.jini.lease.AbstractLeaseMap;
import java.rmi.RemoteException;
import java.time.Duration;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import net.jini.core.lease.Lease;
import net.jini.core.lease.LeaseMap;
import net.jini.core.lease.LeaseMapException;
import net.jini.core.lease.UnknownLeaseException;
import org.awaitility.Awaitility;
import org.dfra.river.fixture.FakeLease;
import org.dfra.river.fixture.SteppedTime;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** The leases of many modules at one lookup service are renewed in few calls. */
@Timeout(60)
class LeaseBatchesTest {

  private static final long LEASE = 30_000;

  private final SteppedTime time = new SteppedTime();
  private final LeaseBatches batches = new LeaseBatches(time);
  private final BlockingQueue<String> givenUp = new LinkedBlockingQueue<>();

  /** Number of leases in each call, in order. */
  private final BlockingQueue<Integer> calls = new LinkedBlockingQueue<>();

  private volatile @Nullable RemoteException failure;
  private volatile @Nullable Error error;

  /** A lease of one of several grantors. */
  private final class BatchedLease extends FakeLease {
    private final String name;
    private final String grantor; // its service ID, which others may copy
    private final String server;

    BatchedLease(String name, String grantor, String server) {
      super(LEASE);
      this.name = name;
      this.grantor = grantor;
      this.server = server;
    }

    @Override
    public void renew(long duration) throws UnknownLeaseException, RemoteException {
      calls.add(1);
      failIfAsked();
      extend(duration);
    }

    private void extend(long duration) throws UnknownLeaseException, RemoteException {
      try {
        super.renew(duration);
      } catch (UnknownLeaseException e) {
        throw new UnknownLeaseException(name);
      }
    }

    @Override
    @SuppressWarnings("rawtypes") // as River declares it
    public LeaseMap createLeaseMap(long duration) {
      return new Batch(this, duration);
    }

    @Override
    public boolean canBatch(Lease other) {
      return ((BatchedLease) other).grantor.equals(grantor);
    }
  }

  private void failIfAsked() throws RemoteException {
    Error unexpected = error;
    if (unexpected != null) {
      throw unexpected;
    }
    RemoteException reason = failure;
    if (reason != null) {
      throw reason;
    }
  }

  private final class Batch extends AbstractLeaseMap {

    Batch(Lease first, long duration) {
      super(first, duration);
    }

    @Override
    public boolean canContainKey(Object key) {
      return key instanceof BatchedLease;
    }

    @Override
    public void renewAll() throws LeaseMapException, RemoteException {
      calls.add(size());
      failIfAsked();
      Map<Lease, Throwable> failed = new HashMap<>();
      for (Object key : keySet()) {
        BatchedLease each = (BatchedLease) key;
        try {
          each.extend((Long) get(each));
        } catch (UnknownLeaseException e) {
          failed.put(each, e);
        }
      }
      if (!failed.isEmpty()) {
        failed.keySet().forEach(this::remove);
        throw new LeaseMapException("some", failed);
      }
    }

    @Override
    public void cancelAll() {
      throw new UnsupportedOperationException();
    }
  }

  private BatchedLease add(String name, String grantor) {
    return add(name, grantor, "server of " + grantor);
  }

  private BatchedLease add(String name, String grantor, String server) {
    BatchedLease lease = new BatchedLease(name, grantor, server);
    var unused = batches.add(lease, LEASE, e -> givenUp.add(name + ": " + e.getMessage()));
    return lease;
  }

  private int call() throws InterruptedException {
    return calls.poll(30, TimeUnit.SECONDS);
  }

  /** Waits for the renewals to be answered: then the next are timed. */
  private void awaitTimed(int leases) {
    Awaitility.await().atMost(Duration.ofSeconds(30)).until(() -> time.waiting() == leases);
  }

  @Test
  void thoseOfOneGrantorAreRenewedTogetherThoseOfAnotherSeparately() throws Exception {
    for (int i = 0; i < 30; i++) {
      add("a" + i, "one");
      time.pass(Duration.ofMillis(100)); // modules start one after the other
    }
    add("b", "other");
    time.pass(Duration.ofSeconds(7));
    assertThat(call()).as("due within the next five seconds").isEqualTo(30);
    assertThat(calls).isEmpty();
    awaitTimed(31);
    time.pass(Duration.ofSeconds(3));
    assertThat(call()).as("of the other grantor").isEqualTo(1);
    awaitTimed(31);
    time.pass(Duration.ofSeconds(7));
    assertThat(call()).as("in the next round").isEqualTo(30);
  }

  @Test
  void noneIsSentToAStrangerThatCopiesAServiceId() throws Exception {
    BatchedLease honest = add("honest", "one", "robot");
    BatchedLease copy = add("copy", "one", "stranger");
    assertThat(honest.canBatch(copy)).as("as reggie's leases say").isTrue();
    assertThat(honest.server).isNotEqualTo(copy.server);
    time.pass(Duration.ofSeconds(10));
    assertThat(List.of(call(), call())).as("leases in each call").containsExactly(1, 1);
  }

  @Test
  void anErrorEndsNoRenewal() throws Exception {
    add("a", "one");
    add("b", "one");
    error = new LinkageError("a class is missing");
    time.pass(Duration.ofSeconds(10));
    assertThat(call()).isEqualTo(2);
    awaitTimed(2);
    error = null;
    time.pass(Duration.ofSeconds(2));
    assertThat(call()).as("tried again").isEqualTo(2);
    awaitTimed(2);
    assertThat(givenUp).isEmpty();
  }

  @Test
  void oneThatIsUnknownIsReportedAndTheOthersGoOn() throws Exception {
    List<BatchedLease> leases = new ArrayList<>();
    for (int i = 0; i < 5; i++) {
      leases.add(add("a" + i, "one"));
    }
    leases.get(3).cancel();
    time.pass(Duration.ofSeconds(10));
    assertThat(call()).isEqualTo(5);
    assertThat(givenUp.poll(30, TimeUnit.SECONDS)).isEqualTo("a3: a3");
    awaitTimed(4);
    time.pass(Duration.ofSeconds(10));
    assertThat(call()).as("in the next round").isEqualTo(4);
    assertThat(givenUp).isEmpty();
  }

  @Test
  void allAreTriedAgainUntilTheirEnd() throws Exception {
    add("a", "one");
    time.pass(Duration.ofSeconds(2));
    add("b", "one");
    failure = new RemoteException("no way there");
    int tries = 0;
    while (givenUp.size() < 2) {
      time.pass(Duration.ofSeconds(1));
      tries += calls.poll(20, TimeUnit.MILLISECONDS) == null ? 0 : 1;
      assertThat(time.nanos()).as("time").isLessThan(Duration.ofMinutes(1).toNanos());
    }
    assertThat(tries).as("tries").isGreaterThan(5);
    assertThat(givenUp.take()).isEqualTo("a: no way there");
    assertThat(givenUp.take()).isEqualTo("b: no way there");
    failure = null;
    time.pass(Duration.ofMinutes(1));
    assertThat(calls).as("nothing is left to renew").isEmpty();
  }

  @Test
  void whatIsRemovedIsNotRenewed() throws Exception {
    add("a", "one");
    batches.remove(
        batches.add(
            new BatchedLease("b", "one", "a server"), LEASE, e -> givenUp.add(e.toString())));
    time.pass(Duration.ofSeconds(10));
    assertThat(call()).isEqualTo(1);
  }

  @Test
  void noCallHasMoreThanItsLimit() throws Exception {
    for (int i = 0; i < LeaseBatches.MOST + 10; i++) {
      add("a" + i, "one");
    }
    time.pass(Duration.ofSeconds(10));
    assertThat(List.of(call(), call())).containsExactlyInAnyOrder(LeaseBatches.MOST, 10);
  }
}
