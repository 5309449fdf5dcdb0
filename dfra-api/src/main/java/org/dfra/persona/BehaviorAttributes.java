package org.dfra.persona;

import java.time.Instant;
import org.jspecify.annotations.Nullable;

/**
 * What a behaviour is for, and whether it is at work.
 *
 * @param goal name of what it can reach, e.g. {@code RasterGoal}
 * @param script whether it is made of other behaviours
 * @param phase what it is at, e.g. {@code RUNNING}
 * @param rate how often it looks at its percepts, hertz, above 0
 * @param heldSince when a person, a parking brake or an emergency stop stopped its goal, by the
 *     robot's clock, UTC; null where none of them has
 */
public record BehaviorAttributes(
    String goal, boolean script, String phase, double rate, @Nullable Instant heldSince)
    implements Attributes {

  /** Of one whose goal nobody has stopped. */
  public BehaviorAttributes(String goal, boolean script, String phase, double rate) {
    this(goal, script, phase, rate, null);
  }

  public BehaviorAttributes {
    AttributeValidation.requireText("goal", goal);
    AttributeValidation.requireText("phase", phase);
    AttributeValidation.requirePositive("rate", rate, "Hz");
  }
}
