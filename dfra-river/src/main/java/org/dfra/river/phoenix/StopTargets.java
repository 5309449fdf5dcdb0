package org.dfra.river.phoenix;

import java.rmi.Remote;
import java.rmi.RemoteException;
import java.rmi.activation.ActivationID;
import java.time.Duration;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.Executor;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import org.dfra.flow.effector.StopState;
import org.dfra.river.call.CallThreads;
import org.dfra.river.phoenix.stop.EffectorStop;
import org.dfra.river.phoenix.stop.GroupStopAnswer;
import org.dfra.river.phoenix.stop.GroupStopAnswer.Stopped;
import org.dfra.river.phoenix.stop.StopTarget;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The objects of a group's virtual machine, for the emergency stop: which of them are effectors,
 * and what each answers.
 *
 * <p>Threads: {@code group-stop-}, one for each effector while it is being stopped. An effector
 * that does not answer delays no other.
 */
final class StopTargets {

  private static final Logger LOG = LoggerFactory.getLogger(StopTargets.class);

  /** An effector waits half a second for its driver, and then writes to a disk. */
  private static final Duration PATIENCE = Duration.ofMillis(900);

  private final Duration patience;
  private final Executor threads;
  private final Map<ActivationID, Object> active = new ConcurrentHashMap<>();
  private volatile Order last = new Order(0, "");

  /** An order to stop, the n-th of this process. */
  private record Order(long number, String by) {}

  StopTargets() {
    this(PATIENCE, CallThreads.pool("group-stop-"));
  }

  /**
   * @param patience how long the effectors may take to answer, all together
   * @param threads where each of them is stopped
   */
  StopTargets(Duration patience, Executor threads) {
    this.patience = patience;
    this.threads = threads;
  }

  /** How many orders there were; noted before an object is made. */
  long orders() {
    return last.number();
  }

  /**
   * An object was made. It is stopped if it is an effector and an order came meanwhile.
   *
   * @param ordersBefore what {@link #orders} was when its making began
   */
  void made(ActivationID id, Remote object, long ordersBefore) {
    active.put(id, object);
    Order now = last; // after the object was put: an order that comes later finds it there
    if (now.number() != ordersBefore && object instanceof StopTarget target) {
      try {
        StopState unused = target.emergencyStop(now.by());
      } catch (RemoteException | RuntimeException e) { // a driver's own
        LOG.error("{} was made during an emergency stop, and not stopped", object, e);
      }
    }
  }

  /** An object is active no longer. */
  void inactive(ActivationID id) {
    active.remove(id);
  }

  /** Stops all effectors at the same time. */
  GroupStopAnswer emergencyStop(String by) {
    synchronized (this) {
      last = new Order(last.number() + 1, by);
    }
    long end = System.nanoTime() + patience.toNanos();
    Map<ActivationID, CompletableFuture<EffectorStop>> orders = new LinkedHashMap<>();
    Map<ActivationID, StopTarget> targets = new LinkedHashMap<>();
    List<ActivationID> others = new ArrayList<>();
    active.forEach(
        (id, object) -> {
          if (object instanceof StopTarget target) {
            targets.put(id, target);
            orders.put(id, order(target, by));
          } else {
            others.add(id);
          }
        });
    List<Stopped> answers = new ArrayList<>();
    targets.forEach(
        (id, target) -> {
          @Nullable CompletableFuture<EffectorStop> order = orders.get(id);
          if (order != null) {
            answers.add(new Stopped(id, answer(target, order, end)));
          }
        });
    return new GroupStopAnswer(answers, others);
  }

  private CompletableFuture<EffectorStop> order(StopTarget target, String by) {
    CompletableFuture<EffectorStop> answer = new CompletableFuture<>();
    Runnable task =
        () -> {
          try {
            answer.complete(stop(target, by));
          } catch (RemoteException | RuntimeException | Error e) { // its answer is the failure
            answer.completeExceptionally(e);
          }
        };
    try {
      threads.execute(task);
    } catch (OutOfMemoryError e) { // there is no room for one more thread; this one will do
      task.run();
    }
    return answer;
  }

  private static EffectorStop stop(StopTarget target, String by) throws RemoteException {
    boolean wasStopped = wasStopped(target);
    StopState now = target.emergencyStop(by);
    return new EffectorStop(target.moduleId(), target.modulePath(), wasStopped, now, null);
  }

  /** A failure of this question must not keep the effector from being stopped. */
  private static boolean wasStopped(StopTarget target) {
    try {
      return target.stopState().latched();
    } catch (RemoteException | RuntimeException e) { // a driver's own
      LOG.warn("{} is stopped, and does not say whether it was stopped before", target, e);
      return false;
    }
  }

  private EffectorStop answer(StopTarget target, CompletableFuture<EffectorStop> order, long end) {
    String fault;
    try {
      return order.get(Math.max(0, end - System.nanoTime()), TimeUnit.NANOSECONDS);
    } catch (TimeoutException e) {
      fault = "it did not answer within " + patience.toMillis() / 1e3 + " s";
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      fault = "the thread that awaited its answer was interrupted";
    } catch (ExecutionException e) {
      LOG.error("{} was not stopped", target.modulePath(), e.getCause());
      fault = "it failed (" + e.getCause() + ")";
    }
    return new EffectorStop(target.moduleId(), target.modulePath(), false, null, fault);
  }
}
