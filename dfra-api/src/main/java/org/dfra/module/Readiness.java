package org.dfra.module;

/**
 * How far a module has come.
 *
 * <pre>
 *   CREATED --start--&gt; INITIALIZING --first data--&gt; READY &lt;==first / last client==&gt; ACTIVE
 *                       ^        |                   |                               |
 *                  retry|        |gave up            |&lt;----- pause / resume ------&gt;PAUSED
 *                       |        v                   |                               |
 *                       +----- FAILED &lt;---- cannot serve by itself any more ---------+
 *
 *   READY, ACTIVE --device lost, to be opened again--&gt; INITIALIZING
 *   every state but STOPPED --stop--&gt; STOPPED
 * </pre>
 */
public enum Readiness {
  /** Constructed; awaits {@code start}. */
  CREATED,
  /** Started; awaits its device and the first data from it. */
  INITIALIZING,
  /** Has data; awaits its first client. */
  READY,
  /** Serves at least one client. */
  ACTIVE,
  /** Works, but withholds its service until it is resumed. */
  PAUSED,
  /** Cannot serve by itself any more; awaits recovery. */
  FAILED,
  /** Ended for good. */
  STOPPED;

  /** Whether a module in this state answers with data. */
  public boolean serves() {
    return this == READY || this == ACTIVE;
  }

  /** Whether a module in this state will never serve without help from outside. */
  public boolean isFailedOrStopped() {
    return this == FAILED || this == STOPPED;
  }

  /** Whether the drawing above has an arrow from this state to {@code next}. */
  public boolean canTransitionTo(Readiness next) {
    return switch (this) {
      case CREATED -> next == INITIALIZING || next == STOPPED;
      case INITIALIZING -> next == READY || next == FAILED || next == STOPPED;
      case READY ->
          next == ACTIVE
              || next == PAUSED
              || next == INITIALIZING
              || next == FAILED
              || next == STOPPED;
      case ACTIVE ->
          next == READY
              || next == PAUSED
              || next == INITIALIZING
              || next == FAILED
              || next == STOPPED;
      case PAUSED -> next == READY || next == ACTIVE || next == FAILED || next == STOPPED;
      case FAILED -> next == INITIALIZING || next == STOPPED;
      case STOPPED -> false;
    };
  }
}
