package org.dfra.river.security.robot;

import java.io.Serializable;
import java.time.Instant;
import java.util.List;
import org.dfra.geometry.GeoPosition;
import org.jspecify.annotations.Nullable;

/**
 * What a robot knows about itself, for the conditions of its policy.
 *
 * @param named facts, by name
 * @param time by its clock; null if the clock was not set
 * @param position null if it is unknown or too old, or no rule of the policy needs it
 * @param isPositionNeeded whether a rule of the policy needs the position
 */
public record KnownFacts(
    List<NamedFact> named,
    @Nullable Instant time,
    @Nullable GeoPosition position,
    boolean isPositionNeeded)
    implements Serializable {

  /** Copies the list. */
  public KnownFacts {
    named = List.copyOf(named);
  }
}
