package org.dfra.module;

import java.io.Serializable;
import java.time.Instant;

/**
 * Something worth remembering in a module's life.
 *
 * @param time when it happened, by the module's clock
 * @param kind what sort of thing
 * @param description what happened, a sentence
 */
public record Incident(Instant time, Kind kind, String description) implements Serializable {

  /** Sorts of incidents. */
  public enum Kind {
    /** The module began to work. */
    ACTIVATION,
    /** The module could not serve any more. */
    FAILURE,
    /** Something was thrown that the module survived. */
    EXCEPTION,
    /** The module served again. */
    RECOVERY,
    /** The module ended as it should. */
    DEACTIVATION,
    /** Something that it listens to fell silent, or is heard again after it was missed. */
    GAP,
    /** An effector was stopped for an emergency. */
    EMERGENCY_STOP,
    /** An effector was released from its emergency stop. */
    RELEASE
  }
}
