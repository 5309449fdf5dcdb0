package org.dfra.event.delivery;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import java.util.ArrayDeque;
import java.util.HashMap;
import java.util.Iterator;
import java.util.LinkedHashSet;
import java.util.Map;
import java.util.Queue;
import java.util.Set;
import java.util.concurrent.Executor;
import org.jspecify.annotations.Nullable;

/**
 * Shares a pool's threads among peers, so that an unresponsive peer delays only itself.
 *
 * <p>A peer is a computer; each of its processes has a queue. A task runs as soon as its process,
 * its peer and all peers together have fewer running tasks than their {@link TaskLimits}; until
 * then it waits in its queue. Queues are served round-robin, so a long queue does not delay a short
 * one. Tasks of a queue start in order of submission.
 *
 * <p>No task is dropped. The submitter bounds the number of waiting tasks: a {@link ListenerQueue}
 * submits one at a time. Thread-safe.
 */
public final class PeerExecutors {

  private final Executor pool;
  private final TaskLimits limits;

  // those with tasks
  @GuardedBy("this")
  private final Map<ProcessKey, ProcessQueue> lanes = new HashMap<>();

  @GuardedBy("this")
  private final Map<Object, Integer> underWayByPeer = new HashMap<>();

  // next one first
  @GuardedBy("this")
  private final Set<ProcessQueue> waiting = new LinkedHashSet<>();

  @GuardedBy("this")
  private int underWay;

  /**
   * How many tasks may run at once.
   *
   * @param perProcess of one process, at least 1
   * @param perPeer of one peer, at least as many
   * @param total of all peers, at least as many
   */
  public record TaskLimits(int perProcess, int perPeer, int total) {
    public TaskLimits {
      if (perProcess < 1 || perPeer < perProcess || total < perPeer) {
        throw new IllegalArgumentException(
            "limits must be 1 <= perProcess %d <= perPeer %d <= inAll %d"
                .formatted(perProcess, perPeer, total));
      }
    }
  }

  private record ProcessKey(Object peer, Object process) {}

  /** The tasks of one process; identity counts. */
  private static final class ProcessQueue {
    final ProcessKey key;
    final Queue<Runnable> tasks = new ArrayDeque<>(); // guarded by the PeerExecutors
    int underWay; // guarded by the PeerExecutors

    ProcessQueue(ProcessKey key) {
      this.key = key;
    }
  }

  /**
   * @param pool runs the tasks on other threads than the caller's; it drops none
   */
  public PeerExecutors(Executor pool, TaskLimits limits) {
    this.pool = pool;
    this.limits = limits;
  }

  /**
   * Runs tasks that call one process. Keeps no state while there are none.
   *
   * @param peer its computer; peers are distinguished by {@code equals}
   * @param process the process on it, distinguished in the same way
   */
  public Executor executorFor(Object peer, Object process) {
    ProcessKey key = new ProcessKey(peer, process);
    return task -> {
      add(key, task);
      startWhatMay();
    };
  }

  /** The number of running tasks. */
  public synchronized int runningTasks() {
    return underWay;
  }

  /** The number of waiting tasks. */
  public synchronized int waitingTasks() {
    return waiting.stream().mapToInt(lane -> lane.tasks.size()).sum();
  }

  private synchronized void add(ProcessKey key, Runnable task) {
    ProcessQueue lane = lanes.computeIfAbsent(key, ProcessQueue::new);
    lane.tasks.add(task);
    waiting.add(lane);
  }

  private void startWhatMay() {
    for (@Nullable StartedTask next = startNext(); next != null; next = startNext()) {
      StartedTask started = next;
      boolean handedOver = false;
      try {
        pool.execute(() -> run(started));
        handedOver = true;
      } finally {
        if (!handedOver) {
          ended(started.lane());
        }
      }
    }
  }

  private record StartedTask(ProcessQueue lane, Runnable task) {}

  private synchronized @Nullable StartedTask startNext() {
    if (underWay >= limits.total()) {
      return null;
    }
    for (Iterator<ProcessQueue> each = waiting.iterator(); each.hasNext(); ) {
      ProcessQueue lane = each.next();
      Object peer = lane.key.peer();
      if (lane.underWay < limits.perProcess()
          && underWayByPeer.getOrDefault(peer, 0) < limits.perPeer()) {
        each.remove();
        Runnable task = lane.tasks.remove();
        if (!lane.tasks.isEmpty()) {
          waiting.add(lane); // behind the others
        }
        lane.underWay++;
        underWayByPeer.merge(peer, 1, Integer::sum);
        underWay++;
        return new StartedTask(lane, task);
      }
    }
    return null;
  }

  private void run(StartedTask started) {
    try {
      started.task().run();
    } finally {
      ended(started.lane());
      startWhatMay();
    }
  }

  private synchronized void ended(ProcessQueue lane) {
    underWay--;
    underWayByPeer.computeIfPresent(
        lane.key.peer(), (peer, count) -> count == 1 ? null : count - 1);
    lane.underWay--;
    if (lane.underWay == 0 && lane.tasks.isEmpty()) {
      lanes.remove(lane.key);
    }
  }
}
