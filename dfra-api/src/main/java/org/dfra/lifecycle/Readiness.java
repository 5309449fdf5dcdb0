package org.dfra.lifecycle;

/**
 * The lifecycle state of a module.
 *
 * <pre>
 *   CREATED --start--&gt; INITIALIZING --first data--&gt; READY &lt;==first / last client==&gt; ACTIVE
 *                       ^        |                   |                               |
 *                  retry|        |gave up            |&lt;----- pause / resume ------&gt;PAUSED
 *                       |        v                   |                               |
 *                       +----- FAILED &lt;---- cannot serve without help --------------+
 *
 *   READY, ACTIVE --device lost, to be opened again--&gt; INITIALIZING
 *   every state but STOPPED --stop--&gt; STOPPED
 * </pre>
 */
public enum Readiness {
  /** Constructed; awaits {@code start}. */
  CREATED,
  /** Started; awaits its device and the device's first data. */
  INITIALIZING,
  /** Has data; awaits its first client. */
  READY,
  /** Serves at least one client. */
  ACTIVE,
  /** Works, but does not serve until it is resumed. */
  PAUSED,
  /** Cannot serve without help; awaits recovery. */
  FAILED,
  /** Ended; cannot be restarted. */
  STOPPED;

  /** Whether a module in this state answers with data. */
  public boolean serves() {
    return this == READY || this == ACTIVE;
  }

  /** Whether a module in this state cannot serve again without external help. */
  public boolean isFailedOrStopped() {
    return this == FAILED || this == STOPPED;
  }

  /** Whether the diagram above has a transition from this state to {@code next}. */
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
