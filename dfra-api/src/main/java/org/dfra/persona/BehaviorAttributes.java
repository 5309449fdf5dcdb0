package org.dfra.persona;

import java.time.Instant;
import org.jspecify.annotations.Nullable;

/**
 * The goal type of a behaviour, and its current phase.
 *
 * @param goal name of its type of goals, e.g. {@code RasterGoal}
 * @param script whether it executes other behaviours
 * @param phase its current phase, e.g. {@code RUNNING}
 * @param rate rate of its control loop, hertz, above 0
 * @param heldSince when an operator, a parking brake or an emergency stop stopped its goal, by the
 *     robot's clock, UTC; null if none of them has
 */
public record BehaviorAttributes(
    String goal, boolean script, String phase, double rate, @Nullable Instant heldSince)
    implements Attributes {

  /** The attributes of a behaviour whose goal is not held. */
  public BehaviorAttributes(String goal, boolean script, String phase, double rate) {
    this(goal, script, phase, rate, null);
  }

  public BehaviorAttributes {
    AttributeValidation.requireText("goal", goal);
    AttributeValidation.requireText("phase", phase);
    AttributeValidation.requirePositive("rate", rate, "Hz");
  }
}
