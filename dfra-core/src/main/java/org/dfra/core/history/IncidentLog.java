package org.dfra.core.history;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import java.io.IOException;
import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.util.ArrayDeque;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Executor;
import org.dfra.core.state.StateStore;
import org.dfra.lifecycle.Incident;
import org.dfra.lifecycle.Incident.Kind;
import org.dfra.module.ModuleHistory;
import org.dfra.time.Scheduler;
import org.slf4j.Logger;

/**
 * A module's history, stored across restarts.
 *
 * <p>Every incident is stored at once, but not by the thread that records it: incidents recorded
 * during a write are stored together by the next write. A crash loses at most these, and the
 * serving time since the last incident.
 */
public final class IncidentLog {

  /** Maximum number of stored incidents; the counters include all. */
  static final int MAX_INCIDENTS = 100;

  private static final String NAME = "history";

  private final String module;
  private final StateStore state;
  private final InstantSource clock;
  private final Scheduler scheduler;
  private final Executor writer;
  private final Logger log;

  /**
   * Taken before this; held while writing, so that an older history never overwrites a newer one.
   */
  private final Object file = new Object();

  @GuardedBy("this")
  private final ArrayDeque<Incident> recent = new ArrayDeque<>();

  @GuardedBy("this")
  private Instant since;

  @GuardedBy("this")
  private long activations;

  @GuardedBy("this")
  private long failures;

  @GuardedBy("this")
  private long exceptions;

  @GuardedBy("this")
  private Duration served = Duration.ZERO;

  @GuardedBy("this")
  private boolean serving;

  @GuardedBy("this")
  private long servingSince;

  @GuardedBy("this")
  private boolean writing;

  @GuardedBy("this")
  private boolean changed;

  /**
   * @param module the module's path, for messages
   * @param state where it is stored
   * @param clock stamps the incidents
   * @param scheduler measures the serving time
   * @param writer runs the writes
   */
  public IncidentLog(
      String module,
      StateStore state,
      InstantSource clock,
      Scheduler scheduler,
      Executor writer,
      Logger log) {
    this.module = module;
    this.state = state;
    this.clock = clock;
    this.scheduler = scheduler;
    this.writer = writer;
    this.log = log;
    this.since = clock.instant();
  }

  /**
   * Loads the history of earlier runs, and starts this one. A run that did not end normally counts
   * as a failure.
   */
  public synchronized void beginLife() {
    since = clock.instant();
    restore();
    if (!recent.isEmpty() && recent.getLast().kind() != Kind.DEACTIVATION) {
      record(Kind.FAILURE, "it ended without being closed: killed, crashed or powered off");
    }
    record(Kind.ACTIVATION, "it was activated, no. " + (activations + 1));
  }

  @GuardedBy("this")
  private void restore() {
    try {
      Optional<byte[]> kept = state.read(NAME);
      if (kept.isPresent()) {
        ModuleHistory history = HistoryCodec.decode(kept.get());
        since = history.since();
        activations = history.activations();
        failures = history.failures();
        exceptions = history.exceptions();
        served = history.servingTime();
        recent.addAll(history.recent());
      }
    } catch (IOException e) {
      log.warn(
          "{}: its history in {} cannot be read and begins again: {}", module, state, e.toString());
    }
  }

  /** Records an incident. */
  public synchronized Incident record(Kind kind, String what) {
    switch (kind) {
      case ACTIVATION -> activations++;
      case FAILURE -> failures++;
      case EXCEPTION -> exceptions++;
      case RECOVERY, DEACTIVATION, GAP, EMERGENCY_STOP, RELEASE -> {
        // neither is counted
      }
    }
    Incident incident = new Incident(clock.instant(), kind, what);
    if (recent.size() == MAX_INCIDENTS) {
      recent.removeFirst();
    }
    recent.addLast(incident);
    changed = true;
    if (!writing) {
      writing = true;
      writer.execute(this::writeChanges);
    }
    return incident;
  }

  /** Sets whether the module serves from now on. */
  public synchronized void setServing(boolean now) {
    if (serving) {
      served = served.plusNanos(scheduler.nanos() - servingSince);
    }
    serving = now;
    servingSince = scheduler.nanos();
  }

  /** The history so far. */
  public synchronized ModuleHistory history() {
    Duration soFar = serving ? served.plusNanos(scheduler.nanos() - servingSince) : served;
    return new ModuleHistory(since, activations, failures, exceptions, soFar, List.copyOf(recent));
  }

  /** Writes all pending changes before it returns. */
  public void flush() {
    synchronized (file) {
      byte[] content;
      synchronized (this) {
        changed = false;
        content = HistoryCodec.encode(history());
      }
      write(content);
    }
  }

  private void writeChanges() {
    while (isChanged()) {
      flush();
    }
  }

  private synchronized boolean isChanged() {
    writing = changed;
    return changed;
  }

  private void write(byte[] content) {
    try {
      state.write(NAME, content);
    } catch (IOException e) {
      log.error("{}: its history cannot be written to {}: {}", module, state, e.toString());
    }
  }
}
