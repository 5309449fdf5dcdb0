package org.dfra.cli.stop;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.time.Duration;
import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.UUID;
import java.util.concurrent.Callable;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import org.dfra.cli.stop.CallQueue.Call;
import org.dfra.river.access.NumericAddress;
import org.dfra.river.call.PeerAddress;
import org.jspecify.annotations.Nullable;

/**
 * Calls the proxies that lookup services list. Any client may register proxies that never answer;
 * these do not delay the other calls.
 *
 * <pre>
 *   lookup services, round robin --&gt; the hosts that proxies name, round robin
 *       --&gt; robots, round robin --&gt; a robot's calls, in order
 *       --&gt; a slot, for at most a quarter of a second --&gt; the answer, or a timeout
 * </pre>
 *
 * <p>A call starts when it gets a slot; the calls of one lookup service have only a part of the
 * slots. A long call continues without its slot. A call without an answer in time is interrupted.
 *
 * <p>The sender of a proxy chooses the address in it, so the address only decides on the order:
 * peers that answer a connection attempt ({@link PeerProbe}) are called first, and the others have
 * half of the slots at most. Thousands of proxies that name a few silent hosts wait for one another
 * only; so do those that name addresses that nobody has. A proxy that names an honest robot's host
 * is answered there at once.
 *
 * <p>Threads: {@code dfra-stop}, one for each running call, and {@code dfra-stop-timer}; from the
 * first call to {@link #close}, which abandons running calls.
 */
final class FairCallScheduler implements AutoCloseable {

  /**
   * Limits of calls.
   *
   * @param slots calls that may start before any has ended
   * @param slotsPerRegistrar of these, for the calls of one lookup service
   * @param threads running calls, including those that have lost their slot
   * @param reserved running calls of each lookup service that may start beyond {@code threads}
   * @param slotTimeout how long a call keeps its slot
   * @param maxQueueTime how long a call waits to start; then it is not made
   */
  record Limits(
      int slots,
      int slotsPerRegistrar,
      int threads,
      int reserved,
      Duration slotTimeout,
      Duration maxQueueTime) {

    /**
     * Starts per second 512 calls of one lookup service to peers that accept connections and then
     * are silent, and 256 to peers that do not.
     */
    static final Limits DEFAULT =
        new Limits(256, 128, 1024, 16, Duration.ofMillis(250), Duration.ofSeconds(15));
  }

  /** A call could not start in time. A retry would fail too. */
  static final class NotCalledException extends Exception {
    private static final long serialVersionUID = 1L;

    NotCalledException(String message) {
      super(message);
    }
  }

  private final Limits limits;
  private final Duration patience;
  private final PeerProbe probe = PeerProbe.start();
  private final @Nullable ClassLoader loader = Thread.currentThread().getContextClassLoader();
  private final ExecutorService threads =
      Executors.newCachedThreadPool(task -> thread(task, "dfra-stop"));
  private final ScheduledExecutorService timer =
      Executors.newSingleThreadScheduledExecutor(task -> thread(task, "dfra-stop-timer"));
  private final Map<UUID, CallQueue> lanes = new LinkedHashMap<>(); // the next one first

  // slots in use
  @GuardedBy("this")
  private int places;

  @GuardedBy("this")
  private int underWay;

  @GuardedBy("this")
  private boolean closed;

  /**
   * @param patience timeout of a call, from its start
   */
  FairCallScheduler(Limits limits, Duration patience) {
    this.limits = limits;
    this.patience = patience;
  }

  private Thread thread(Runnable task, String name) {
    Thread thread = new Thread(task, name);
    thread.setDaemon(true);
    thread.setContextClassLoader(loader);
    return thread;
  }

  /**
   * Makes a call as soon as there is a slot for it.
   *
   * @param registrar the lookup service that lists the called proxy
   * @param peer the address in the proxy; null if it has none
   * @param robot the robot that it is listed for
   * @return its answer; a {@link TimeoutException} if there is none in time, a {@link
   *     NotCalledException} if it could not start
   */
  CompletableFuture<Outcome> call(
      UUID registrar, @Nullable PeerAddress peer, String robot, Callable<Outcome> code) {
    Call call = new Call(registrar, peer, robot, code);
    @Nullable InetAddress numeric = peer == null ? null : NumericAddress.parse(peer.host());
    synchronized (this) {
      if (!closed) {
        call.answersProbe = numeric == null; // it cannot be asked, and has one group of its own
        lane(call).add(call);
        later(limits.maxQueueTime(), () -> expire(call));
      }
    }
    begin();
    if (peer != null && numeric != null) {
      CompletableFuture<Void> unused =
          probe
              .answered(new InetSocketAddress(numeric, peer.port()))
              .thenRun(() -> prioritize(call));
    }
    return call.answer;
  }

  /** Its peer answers connection attempts. */
  private void prioritize(Call call) {
    synchronized (this) {
      boolean isWaiting = lane(call).remove(call);
      call.answersProbe = true;
      if (isWaiting) {
        lane(call).add(call);
      } else if (call.hasPlace) {
        lane(call).unansweredPlaces--;
      }
    }
    begin();
  }

  /** Holds the lock; nothing is closed. */
  private void later(Duration after, Runnable task) {
    var unused = timer.schedule(task, after.toNanos(), TimeUnit.NANOSECONDS);
  }

  /** Starts as many calls as there are slots for. */
  private void begin() {
    synchronized (this) {
      @Nullable Call next = closed ? null : next();
      while (next != null && start(next)) {
        next = next();
      }
    }
  }

  /** Removes the next call from the queues, if one may start. */
  @GuardedBy("this")
  private @Nullable Call next() {
    if (places >= limits.slots()) {
      return null;
    }
    for (Iterator<Map.Entry<UUID, CallQueue>> all = lanes.entrySet().iterator(); all.hasNext(); ) {
      Map.Entry<UUID, CallQueue> each = all.next();
      UUID registrar = each.getKey();
      CallQueue lane = each.getValue();
      @Nullable Call call = next(lane);
      if (call != null) {
        all.remove();
        lanes.put(registrar, lane); // the others are next
        return call;
      }
    }
    return null;
  }

  /** Removes the next call of a lookup service; null if none may start. */
  @GuardedBy("this")
  private @Nullable Call next(CallQueue lane) {
    if (lane.places >= limits.slotsPerRegistrar()
        || (underWay >= limits.threads() && lane.underWay >= limits.reserved())) {
      return null;
    }
    return lane.take(lane.unansweredPlaces < Math.max(1, limits.slotsPerRegistrar() / 2));
  }

  /** Whether a thread was started for it. */
  @GuardedBy("this")
  private boolean start(Call call) {
    CallQueue lane = lane(call);
    call.begun = true;
    call.hasPlace = true;
    places++;
    lane.places++;
    lane.unansweredPlaces += call.answersProbe ? 0 : 1;
    underWay++;
    lane.underWay++;
    try {
      threads.execute(() -> run(call));
    } catch (OutOfMemoryError e) { // no thread can be started now
      ended(call);
      call.begun = false;
      lane.addFirst(call);
      later(limits.slotTimeout(), this::begin);
      return false;
    }
    later(limits.slotTimeout(), () -> leavePlace(call));
    later(patience, () -> timeOut(call));
    return true;
  }

  private CallQueue lane(Call call) {
    return lanes.computeIfAbsent(call.registrar, unused -> new CallQueue());
  }

  private void run(Call call) {
    boolean isWanted;
    synchronized (this) {
      isWanted = !call.answer.isDone();
      call.runner = Thread.currentThread();
    }
    if (isWanted) {
      try {
        call.answer.complete(call.code.call());
      } catch (Exception | Error e) { // a proxy may throw anything; it becomes the reason
        call.answer.completeExceptionally(e);
      }
    }
    synchronized (this) {
      call.runner = null;
      boolean unused = Thread.interrupted(); // of an abandoned call
      ended(call);
    }
    begin();
  }

  @GuardedBy("this")
  private void ended(Call call) {
    underWay--;
    lane(call).underWay--;
    freePlace(call);
  }

  @GuardedBy("this")
  private void freePlace(Call call) {
    if (call.hasPlace) {
      call.hasPlace = false;
      places--;
      lane(call).places--;
      lane(call).unansweredPlaces -= call.answersProbe ? 0 : 1;
    }
  }

  private void leavePlace(Call call) {
    synchronized (this) {
      freePlace(call);
    }
    begin();
  }

  private void timeOut(Call call) {
    if (call.answer.completeExceptionally(new TimeoutException())) {
      synchronized (this) {
        if (call.runner != null) {
          call.runner.interrupt();
        }
      }
    }
  }

  private void expire(Call call) {
    int before;
    synchronized (this) {
      if (call.begun) {
        return;
      }
      call.begun = true; // never
      before = underWay;
      boolean unused = lane(call).remove(call);
    }
    call.answer.completeExceptionally(
        new NotCalledException(
            "it was not called within "
                + limits.maxQueueTime().toMillis() / 1e3
                + " s: "
                + before
                + " other calls do not end"));
  }

  @Override
  public void close() {
    synchronized (this) {
      closed = true;
      lanes.values().forEach(CallQueue::clear);
    }
    probe.close();
    timer.shutdownNow();
    threads.shutdownNow();
  }
}
