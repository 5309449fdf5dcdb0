package org.dfra.core.module;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import java.time.Duration;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.Condition;
import java.util.concurrent.locks.ReentrantLock;
import org.dfra.core.event.EventHub;
import org.dfra.core.history.IncidentLog;
import org.dfra.event.ModuleEvent;
import org.dfra.lifecycle.Incident;
import org.dfra.lifecycle.Readiness;
import org.dfra.time.Scheduler;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;

/**
 * The state machine of one module, with the states and transitions of {@link Readiness}. Every
 * transition wakes waiting threads, is published, and is recorded in the history if the module
 * stops serving or serves again. All that happens under one lock, so all observers see the
 * transitions in the same order.
 *
 * <p>It begins once and ends once; after its end there are no more transitions.
 */
final class Lifecycle {

  private final String module;
  private final Logger log;
  private final EventHub events;
  private final IncidentLog history;

  private final ReentrantLock lock = new ReentrantLock();
  private final Condition readinessChanged;

  @GuardedBy("lock")
  private Readiness readiness = Readiness.CREATED;

  // the reason for the last transition, if given
  @GuardedBy("lock")
  private @Nullable String why;

  @GuardedBy("lock")
  private boolean started;

  @GuardedBy("lock")
  private boolean closed;

  // it has stopped serving, and not resumed since
  @GuardedBy("lock")
  private boolean lapsed;

  @GuardedBy("lock")
  private int clients;

  /**
   * @param module the module's path, {@code robot/name}
   * @param log the module's log
   * @param scheduler the clock for timeouts
   */
  Lifecycle(String module, Logger log, EventHub events, IncidentLog history, Scheduler scheduler) {
    this.module = module;
    this.log = log;
    this.events = events;
    this.history = history;
    this.readinessChanged = scheduler.newCondition(lock);
  }

  /** Begins: moves to {@link Readiness#INITIALIZING}. False if it has begun or ended before. */
  boolean begin() {
    lock.lock();
    try {
      if (started || closed) {
        return false;
      }
      started = true;
      history.beginLife();
      transitionTo(Readiness.INITIALIZING);
      return true;
    } finally {
      lock.unlock();
    }
  }

  /** Whether it has ever begun. */
  boolean wasStarted() {
    lock.lock();
    try {
      return started;
    } finally {
      lock.unlock();
    }
  }

  /** Ends: moves to {@link Readiness#STOPPED}. False if it has ended before. */
  boolean end() {
    lock.lock();
    try {
      if (closed) {
        return false;
      }
      transitionTo(Readiness.STOPPED);
      closed = true;
      if (started) {
        recordIncident(Incident.Kind.DEACTIVATION, "it was closed");
      }
      return true;
    } finally {
      lock.unlock();
    }
  }

  /** Moves to {@link Readiness#FAILED}, if there is a transition. */
  void failIfAlive(String why) {
    lock.lock();
    try {
      if (readiness.canTransitionTo(Readiness.FAILED)) {
        transitionTo(Readiness.FAILED, why);
      }
    } finally {
      lock.unlock();
    }
  }

  /** The current state. */
  Readiness readiness() {
    lock.lock();
    try {
      return readiness;
    } finally {
      lock.unlock();
    }
  }

  /**
   * Waits until it serves or never will; returns the state then, or at the timeout or interruption.
   */
  Readiness await(Duration patience) {
    lock.lock();
    try {
      long nanos = TimeUnit.NANOSECONDS.convert(patience); // saturates if too long
      while (!readiness.serves() && !readiness.isFailedOrStopped() && nanos > 0) {
        nanos = readinessChanged.awaitNanos(nanos);
      }
      return readiness;
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return readiness;
    } finally {
      lock.unlock();
    }
  }

  /** The reason for the last transition, as a clause; empty if none was given. */
  Optional<String> reason() {
    lock.lock();
    try {
      return Optional.ofNullable(why);
    } finally {
      lock.unlock();
    }
  }

  /** As {@link ModuleImpl#transitionTo(Readiness)}. */
  void transitionTo(Readiness next) {
    transitionTo(next, "it went from serving to " + next, null);
  }

  /** As {@link ModuleImpl#transitionTo(Readiness, String)}. */
  void transitionTo(Readiness next, String reason) {
    transitionTo(next, reason, reason);
  }

  private void transitionTo(Readiness next, String incident, @Nullable String reason) {
    lock.lock();
    try {
      if (readiness == next || closed) {
        return;
      }
      if (!readiness.canTransitionTo(next)) {
        throw new IllegalStateException(module + " cannot go from " + readiness + " to " + next);
      }
      Readiness last = readiness;
      log.info("{}: {} -> {}", module, last, next);
      readiness = next;
      why = reason;
      readinessChanged.signalAll();
      history.setServing(next.serves());
      events.publish(new ModuleEvent.ReadinessChanged(last, next));
      remember(last, next, incident);
      if (next == Readiness.READY && clients > 0) {
        transitionTo(Readiness.ACTIVE);
      }
    } finally {
      lock.unlock();
    }
  }

  @GuardedBy("lock")
  private void remember(Readiness last, Readiness next, String incident) {
    if (next == Readiness.FAILED || (last.serves() && next == Readiness.INITIALIZING)) {
      lapsed = true;
      recordIncident(Incident.Kind.FAILURE, incident);
    } else if (lapsed && next.serves()) {
      lapsed = false;
      recordIncident(Incident.Kind.RECOVERY, "it serves again");
    }
  }

  /** Records an incident in the history, and notifies the listeners. */
  void recordIncident(Incident.Kind kind, String what) {
    events.publish(new ModuleEvent.IncidentRecorded(history.record(kind, what)));
  }

  /** Sets the number of clients: a ready module is active if there are any, else not. */
  void setClientCount(int number) {
    lock.lock();
    try {
      clients = number;
      if (closed) {
        return;
      }
      if (number > 0 && readiness == Readiness.READY) {
        transitionTo(Readiness.ACTIVE);
      } else if (number == 0 && readiness == Readiness.ACTIVE) {
        transitionTo(Readiness.READY);
      }
    } finally {
      lock.unlock();
    }
  }
}
