package org.dfra.app.stop;

import java.time.Duration;
import java.util.ArrayDeque;
import java.util.Deque;
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
import org.jspecify.annotations.Nullable;

/**
 * Calls the proxies that lookup services list. Any client may register proxies that never answer;
 * these do not delay the other calls.
 *
 * <pre>
 *   lookup services, round robin --&gt; their robots, round robin --&gt; a robot's calls, in order
 *       --&gt; a slot, for at most a quarter of a second --&gt; the answer, or a timeout
 * </pre>
 *
 * <p>A call starts when it gets a slot; the calls of one lookup service have only a part of the
 * slots. A long call continues without its slot. A call without an answer in time is interrupted.
 * Calls are not grouped by the address in a proxy, since its sender chooses it.
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

    /** Starts 512 unresponsive calls of one lookup service per second. */
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

  private static final class Call {
    final UUID registrar;
    final String robot;
    final Callable<Outcome> code;
    final CompletableFuture<Outcome> answer = new CompletableFuture<>();
    boolean begun; // guarded by the outer object, like all below
    boolean hasPlace;
    @Nullable Thread runner; // while the call runs

    Call(UUID registrar, String robot, Callable<Outcome> code) {
      this.registrar = registrar;
      this.robot = robot;
      this.code = code;
    }
  }

  /** The calls of one lookup service; guarded by the outer object. */
  private static final class CallQueue {
    final Map<String, Deque<Call>> waiting = new LinkedHashMap<>(); // by robot, the next one first
    int places;
    int underWay;
  }

  private final Limits limits;
  private final Duration patience;
  private final @Nullable ClassLoader loader = Thread.currentThread().getContextClassLoader();
  private final ExecutorService threads =
      Executors.newCachedThreadPool(task -> thread(task, "dfra-stop"));
  private final ScheduledExecutorService timer =
      Executors.newSingleThreadScheduledExecutor(task -> thread(task, "dfra-stop-timer"));
  private final Map<UUID, CallQueue> lanes = new LinkedHashMap<>(); // the next one first
  private int places; // slots in use; guarded by this
  private int underWay; // guarded by this
  private boolean closed; // guarded by this

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
   * @param robot the robot that it is listed for
   * @return its answer; a {@link TimeoutException} if there is none in time, a {@link
   *     NotCalledException} if it could not start
   */
  CompletableFuture<Outcome> call(UUID registrar, String robot, Callable<Outcome> code) {
    Call call = new Call(registrar, robot, code);
    synchronized (this) {
      if (!closed) {
        lanes
            .computeIfAbsent(registrar, unused -> new CallQueue())
            .waiting
            .computeIfAbsent(robot, unused -> new ArrayDeque<>())
            .add(call);
        later(limits.maxQueueTime(), () -> expire(call));
      }
    }
    begin();
    return call.answer;
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
  private @Nullable Call next() {
    if (places >= limits.slots()) {
      return null;
    }
    for (Iterator<Map.Entry<UUID, CallQueue>> all = lanes.entrySet().iterator(); all.hasNext(); ) {
      Map.Entry<UUID, CallQueue> each = all.next();
      UUID registrar = each.getKey();
      CallQueue lane = each.getValue();
      if (!lane.waiting.isEmpty()
          && lane.places < limits.slotsPerRegistrar()
          && (underWay < limits.threads() || lane.underWay < limits.reserved())) {
        all.remove();
        lanes.put(registrar, lane); // the others are next
        return take(lane);
      }
    }
    return null;
  }

  private static Call take(CallQueue lane) {
    Iterator<Map.Entry<String, Deque<Call>>> robots = lane.waiting.entrySet().iterator();
    Map.Entry<String, Deque<Call>> first = robots.next();
    String robot = first.getKey();
    Deque<Call> calls = first.getValue();
    robots.remove();
    Call call = calls.remove();
    if (!calls.isEmpty()) {
      lane.waiting.put(robot, calls);
    }
    return call;
  }

  /** Whether a thread was started for it. Holds the lock. */
  private boolean start(Call call) {
    CallQueue lane = lane(call);
    call.begun = true;
    call.hasPlace = true;
    places++;
    lane.places++;
    underWay++;
    lane.underWay++;
    try {
      threads.execute(() -> run(call));
    } catch (OutOfMemoryError e) { // no thread can be started now
      ended(call);
      call.begun = false;
      lane.waiting.computeIfAbsent(call.robot, unused -> new ArrayDeque<>()).addFirst(call);
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

  /** Holds the lock. */
  private void ended(Call call) {
    underWay--;
    lane(call).underWay--;
    freePlace(call);
  }

  /** Holds the lock. */
  private void freePlace(Call call) {
    if (call.hasPlace) {
      call.hasPlace = false;
      places--;
      lane(call).places--;
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
      Map<String, Deque<Call>> waiting = lane(call).waiting;
      @Nullable Deque<Call> calls = waiting.get(call.robot);
      if (calls != null && calls.remove(call) && calls.isEmpty()) {
        waiting.remove(call.robot);
      }
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
      lanes.values().forEach(lane -> lane.waiting.clear());
    }
    timer.shutdownNow();
    threads.shutdownNow();
  }
}
