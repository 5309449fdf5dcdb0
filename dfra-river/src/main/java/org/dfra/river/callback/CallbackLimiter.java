package org.dfra.river.callback;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import java.rmi.Remote;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.Executor;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;
import org.dfra.event.delivery.DeliveryPool;
import org.dfra.event.delivery.PeerExecutors;
import org.dfra.river.call.CallbackProxies;
import org.dfra.time.Scheduler;
import org.jspecify.annotations.Nullable;

/**
 * Limits the client processes that this process calls back.
 *
 * <p>The calls run on the {@link DeliveryPool}, in {@link PeerExecutors}. All other computers
 * together use at most {@value #MAX_REMOTE_THREADS} of its threads, and this computer's own
 * processes as many, so the modules' listeners in this process always have some. One address uses
 * at most {@value #MAX_THREADS_PER_ADDRESS} threads, and one process {@value
 * #MAX_THREADS_PER_PROCESS}. JERI keeps three threads for each connected process, and for a while
 * after the last call. So the number of processes of an address is also limited, and the slot of a
 * process becomes free {@value #LINGER_SECONDS} s after its last object. The limits apply to this
 * virtual machine. Thread-safe.
 */
public final class CallbackLimiter {

  private static final int MAX_REMOTE_THREADS = 24;
  private static final int MAX_THREADS_PER_ADDRESS = 6;
  private static final int MAX_THREADS_PER_PROCESS = 4;

  /** JERI checks every 15 s for connections that were not used since the last check. */
  private static final long LINGER_SECONDS = 35;

  private static final long LINGER_NANOS = TimeUnit.SECONDS.toNanos(LINGER_SECONDS);

  private static final PeerQuota.QuotaLimits PROCESSES = new PeerQuota.QuotaLimits(12, 48, 512);

  private static final CallbackLimiter SHARED =
      new CallbackLimiter(DeliveryPool.shared(), Scheduler.system());

  private final PeerExecutors others;
  private final PeerExecutors own;
  private final Scheduler scheduler;
  private final PeerQuota quota =
      new PeerQuota("processes that are called back from here", PROCESSES);

  @GuardedBy("this")
  private final Map<Peer, ProcessSlots> places = new HashMap<>();

  private record Peer(ClientAddress client, Object process) {}

  /** The slots of the objects of one process. */
  private static final class ProcessSlots {
    int count; // guarded by the peers
    long since; // guarded by the peers: the time when the count became 0
    boolean isAwaited; // guarded by the peers: whether a task to release it is scheduled
  }

  /**
   * @param pool runs the calls
   * @param scheduler schedules the release of a process
   */
  CallbackLimiter(DeliveryPool pool, Scheduler scheduler) {
    this.others =
        new PeerExecutors(
            pool,
            new PeerExecutors.TaskLimits(
                MAX_THREADS_PER_PROCESS, MAX_THREADS_PER_ADDRESS, MAX_REMOTE_THREADS));
    this.own =
        new PeerExecutors(
            pool,
            new PeerExecutors.TaskLimits(
                MAX_THREADS_PER_PROCESS, MAX_REMOTE_THREADS, MAX_REMOTE_THREADS));
    this.scheduler = scheduler;
  }

  /** The limiter of this virtual machine. */
  public static CallbackLimiter shared() {
    return SHARED;
  }

  /**
   * Admits an object for callbacks.
   *
   * @param client the client that registers it
   * @param callback its proxy, as received
   * @throws CallbackRefusedException if it is in a further process of its client and that client's
   *     processes have reached their limit; or if it is on another computer and calls on it have no
   *     deadline
   */
  public synchronized CallbackSlot admit(ClientAddress client, Remote callback)
      throws CallbackRefusedException {
    if (!client.isLocal() && !CallbackProxies.isAllowedRemotely(callback)) {
      throw new CallbackRefusedException(
          "an object on "
              + client.host()
              + " is not called back: no deadline ends a call by its proxy; export it by JERI over"
              + " TCP");
    }
    Peer peer = new Peer(client, CallbackProxies.processKey(callback));
    @Nullable ProcessSlots known = places.get(peer);
    if (known == null) {
      Optional<String> refusal = quota.acquire(client);
      if (refusal.isPresent()) {
        throw new CallbackRefusedException(refusal.get());
      }
      known = new ProcessSlots();
      places.put(peer, known);
    }
    known.count++;
    ProcessSlots held = known;
    PeerExecutors lanes = client.isLocal() ? own : others;
    return new CallbackSlot(
        lanes.executorFor(client.host(), peer.process()), () -> giveBack(peer, held));
  }

  private synchronized void giveBack(Peer peer, ProcessSlots held) {
    held.count--;
    if (held.count == 0) {
      held.since = scheduler.nanos();
      if (!held.isAwaited) {
        await(peer, held, LINGER_NANOS);
      }
    }
  }

  private void await(Peer peer, ProcessSlots held, long nanos) {
    held.isAwaited = true;
    Scheduler.ScheduledTask unused = scheduler.after(nanos, () -> releaseIfLingered(peer, held));
  }

  private synchronized void releaseIfLingered(Peer peer, ProcessSlots held) {
    held.isAwaited = false;
    if (held.count > 0) {
      return;
    }
    long left = held.since + LINGER_NANOS - scheduler.nanos();
    if (left > 0) { // it had an object again meanwhile
      await(peer, held, left);
    } else {
      places.remove(peer);
      quota.release(peer.client());
    }
  }

  /** The number of counted processes, including those that are no longer called but linger. */
  public int processCount() {
    return quota.held();
  }

  /** The resources that this process reserves for one object that it calls back, until closed. */
  public static final class CallbackSlot implements AutoCloseable {

    private final Executor lane;
    private final Runnable whenClosed;
    private final AtomicBoolean closed = new AtomicBoolean();

    CallbackSlot(Executor lane, Runnable whenClosed) {
      this.lane = lane;
      this.whenClosed = whenClosed;
    }

    /**
     * Runs the calls on the object; it drops none. The submitter bounds the number of waiting
     * calls.
     */
    public Executor lane() {
      return lane;
    }

    /** Releases the slot. Idempotent. */
    @Override
    public void close() {
      if (closed.compareAndSet(false, true)) {
        whenClosed.run();
      }
    }
  }
}
