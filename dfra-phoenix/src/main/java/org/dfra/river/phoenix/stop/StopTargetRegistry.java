package org.dfra.river.phoenix.stop;

import java.rmi.Remote;
import java.rmi.RemoteException;
import java.rmi.activation.ActivationID;
import java.time.Duration;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.UUID;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.Executor;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import org.dfra.flow.effector.EmergencyStopState;
import org.dfra.river.call.CallThreads;
import org.dfra.river.phoenix.stop.GroupStopResult.EffectorAnswer;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The effectors among the objects of a group's virtual machine, for the emergency stop, and their
 * answers.
 *
 * <p>Threads: {@code group-stop-}, one for each effector while it is being stopped. An effector
 * that does not answer delays no other.
 */
public final class StopTargetRegistry {

  private static final Logger LOG = LoggerFactory.getLogger(StopTargetRegistry.class);

  /** An effector waits up to 0.5 s for its driver, and then writes to a disk. */
  private static final Duration PATIENCE = Duration.ofMillis(900);

  private final Duration patience;
  private final Executor threads;
  private final Map<ActivationID, Object> active = new ConcurrentHashMap<>();
  private volatile NumberedStopRequest last = new NumberedStopRequest(0, "");

  /** A stop request, the n-th of this process. */
  private record NumberedStopRequest(long number, String by) {}

  public StopTargetRegistry() {
    this(PATIENCE, CallThreads.pool("group-stop-"));
  }

  /**
   * @param timeout the longest wait for all effectors together
   * @param threads run the stops
   */
  StopTargetRegistry(Duration timeout, Executor threads) {
    this.patience = timeout;
    this.threads = threads;
  }

  /** The number of stop requests so far; read before an object is instantiated. */
  public long requestCount() {
    return last.number();
  }

  /**
   * Adds an object. Stops it if it is an effector and a request came meanwhile.
   *
   * @param ordersBefore what {@link #requestCount} was when its instantiation began
   */
  public void made(ActivationID id, Remote object, long ordersBefore) {
    active.put(id, object);
    NumberedStopRequest now = last; // after the object was put: a later request finds it there
    if (now.number() != ordersBefore && object instanceof StopTarget target) {
      try {
        EmergencyStopState unused = target.emergencyStop(now.by());
      } catch (RemoteException | RuntimeException e) { // of a driver
        LOG.error("{} was created during an emergency stop, but could not be stopped", object, e);
      }
    }
  }

  /** Removes an object that became inactive. */
  public void inactive(ActivationID id) {
    active.remove(id);
  }

  /** Stops all effectors at the same time. */
  public GroupStopResult emergencyStop(String by) {
    synchronized (this) {
      last = new NumberedStopRequest(last.number() + 1, by);
    }
    long end = System.nanoTime() + patience.toNanos();
    Map<ActivationID, CompletableFuture<EffectorStopResult>> orders = new LinkedHashMap<>();
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
    List<EffectorAnswer> answers = new ArrayList<>();
    targets.forEach(
        (id, target) -> {
          @Nullable CompletableFuture<EffectorStopResult> order = orders.get(id);
          if (order != null) {
            answers.add(new EffectorAnswer(id, answer(target, order, end)));
          }
        });
    return new GroupStopResult(answers, others);
  }

  private CompletableFuture<EffectorStopResult> order(StopTarget target, String by) {
    CompletableFuture<EffectorStopResult> answer = new CompletableFuture<>();
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
    } catch (OutOfMemoryError e) { // no room for one more thread; use this one
      task.run();
    }
    return answer;
  }

  private static EffectorStopResult stop(StopTarget target, String by) throws RemoteException {
    boolean wasStopped = wasStopped(target);
    EmergencyStopState now = target.emergencyStop(by);
    return new EffectorStopResult(target.moduleId(), target.modulePath(), wasStopped, now, null);
  }

  /** A failure of this query must not prevent the stop of the effector. */
  private static boolean wasStopped(StopTarget target) {
    try {
      return target.emergencyStopState().latched();
    } catch (RemoteException | RuntimeException e) { // of a driver
      LOG.warn("{} is stopped, and does not say whether it was stopped before", target, e);
      return false;
    }
  }

  private EffectorStopResult answer(
      StopTarget target, CompletableFuture<EffectorStopResult> order, long end) {
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
    return new EffectorStopResult(target.moduleId(), target.modulePath(), false, null, fault);
  }

  /** An activatable object that phoenix can stop: the server of an effector. */
  public interface StopTarget {

    /** The module's identity, its service ID in every lookup service. */
    UUID moduleId();

    /** The module's path, {@code robot/name}. */
    String modulePath();

    /** See {@link org.dfra.flow.effector.Effector#emergencyStopState}. */
    EmergencyStopState emergencyStopState() throws RemoteException;

    /** See {@link org.dfra.flow.effector.Effector#emergencyStop}. */
    EmergencyStopState emergencyStop(@Nullable String by) throws RemoteException;
  }
}
