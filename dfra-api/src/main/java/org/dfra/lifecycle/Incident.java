package org.dfra.lifecycle;

import java.io.Serializable;
import java.time.Instant;

/**
 * A recorded event in a module's history.
 *
 * @param time when it happened, by the module's clock
 * @param kind kind of incident
 * @param description what happened, a sentence
 */
public record Incident(Instant time, Kind kind, String description) implements Serializable {

  /** Kinds of incidents. */
  public enum Kind {
    /** The module was activated. */
    ACTIVATION,
    /** The module failed and no longer serves. */
    FAILURE,
    /** The module caught an exception and continued. */
    EXCEPTION,
    /** The module serves again. */
    RECOVERY,
    /** The module was deactivated normally. */
    DEACTIVATION,
    /** A module that it subscribes to stopped publishing, or resumed after a gap. */
    GAP,
    /** An effector made an emergency stop. */
    EMERGENCY_STOP,
    /** An effector's emergency stop was released. */
    RELEASE
  }
}
