package org.dfra.examples.mission.monitor;

import java.time.Instant;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import org.dfra.examples.mission.monitor.MissionMonitor.InjectedFault;
import org.jspecify.annotations.Nullable;

/**
 * A service of one robot is down during a part of its search. The robot continues. What takes long
 * runs in a thread of its own.
 *
 * <pre>
 *   PENDING --share done--&gt; STOPPING --stopped--&gt; DOWN --more done--&gt; RECOVERING
 *                                                       |                     |
 *                            permanent, search ended    v                     v it is back
 *                                                      DONE                  DONE
 * </pre>
 *
 * @param <R> the runtime of a robot
 * @param <T> what the restart returns
 */
public abstract class Outage<R, T> implements InjectedFault<R> {

  /** The share of an outage that does not end. */
  public static final double NEVER = Double.POSITIVE_INFINITY;

  private enum State {
    /** Waits until the robot has done a share of its search. */
    PENDING,
    /** Waits until the service has stopped. */
    STOPPING,
    /** Waits until the robot has done more. */
    DOWN,
    /** Waits until the service is back. */
    RECOVERING,
    /** The fault has ended, or will not occur. */
    DONE
  }

  private final int robot;
  private final double from;
  private final double to;
  private final ExecutorService operator;
  private State state = State.PENDING;

  // known once it is stopped
  private double done;
  private Instant stopped = Instant.MIN;
  private Instant restarted = Instant.MIN;
  private @Nullable Future<?> stop; // the operator's thread
  private @Nullable Future<T> restart;

  /**
   * @param robot its index, from 0
   * @param from share of its search after which the service is stopped
   * @param to share after which it is restarted; {@link #NEVER} for a permanent outage
   * @param thread name of the thread that stops and restarts it
   */
  protected Outage(int robot, double from, double to, String thread) {
    this.robot = robot;
    this.from = from;
    this.to = to;
    this.operator = Executors.newSingleThreadExecutor(task -> new Thread(task, thread));
  }

  /** Whether the service may be stopped now; if not, it is stopped later. */
  protected boolean isStopAllowed() {
    return true;
  }

  /**
   * Reads what is to be there again later.
   *
   * @return stops the service
   */
  protected abstract Callable<?> prepareStop(SearchingRobot<R> victim) throws Exception;

  /** Reports that the service has stopped. */
  protected abstract void reportStop(FaultInjectionContext<R> now, SearchingRobot<R> victim);

  /** Restarts the service. */
  protected abstract T restart(SearchingRobot<R> victim) throws Exception;

  /**
   * Reports the recovery.
   *
   * @param result of the restart
   * @return whether everything is there again
   */
  protected abstract boolean reportRecovery(
      FaultInjectionContext<R> now, SearchingRobot<R> victim, T result) throws Exception;

  /** Reports the end of the search during a permanent outage. */
  protected void reportEnd(FaultInjectionContext<R> now, SearchingRobot<R> victim) {}

  /** The time of the stop. */
  protected final Instant stopped() {
    return stopped;
  }

  /** The time of the restart. */
  protected final Instant restarted() {
    return restarted;
  }

  /** The part of its region that the robot has searched since the stop, percent. */
  protected final double percentSearchedSince(SearchingRobot<R> victim) {
    return 100 * (victim.subscriptions().latestStatus().completion() - done);
  }

  @Override
  public final void update(FaultInjectionContext<R> now) throws Exception {
    SearchingRobot<R> victim = now.robots().get(robot);
    double share = victim.subscriptions().latestStatus().completion();
    boolean hasEnded = victim.hasEnded();
    switch (state) {
      case PENDING -> {
        if (hasEnded) {
          state = State.DONE;
        } else if (share >= from && isStopAllowed()) {
          stop = operator.submit(prepareStop(victim));
          stopped = now.clock().instant();
          done = share;
          state = State.STOPPING;
        }
      }
      case STOPPING -> {
        if (result(stop).isPresent()) {
          reportStop(now, victim);
          state = State.DOWN;
        }
      }
      case DOWN -> {
        if (hasEnded && to == NEVER) {
          reportEnd(now, victim);
          state = State.DONE;
        } else if (hasEnded || share >= to) {
          restarted = now.clock().instant();
          restart = operator.submit(() -> restart(victim));
          state = State.RECOVERING;
        }
      }
      case RECOVERING -> {
        Optional<T> result = result(restart);
        if (result.isPresent() && reportRecovery(now, victim, result.get())) {
          state = State.DONE;
        }
      }
      default -> {}
    }
  }

  /** The result of the operator's work; empty if it is not complete. Rethrows its exception. */
  private static <V> Optional<V> result(@Nullable Future<V> work) throws Exception {
    return work == null || !work.isDone() ? Optional.empty() : Optional.of(work.get());
  }

  @Override
  public final boolean hasStarted() {
    return state != State.PENDING;
  }

  @Override
  public final boolean isOver() {
    return state == State.DONE;
  }

  @Override
  public final void close() {
    operator.shutdownNow();
  }
}
