package org.dfra.persona;

import java.util.List;
import org.jspecify.annotations.Nullable;

/**
 * The capabilities of a robot as a helper.
 *
 * @param percepts what it can observe, e.g. {@code mine}; sorted
 * @param speed its speed when it travels to a call, metres per second, above 0
 * @param strategy its decision strategy, e.g. {@code affective}
 * @param replaceAfter a helper that is late by this is replaced by another, seconds, above 0
 * @param margin a helper gives up this long before that time, seconds, above 0; {@code
 *     replaceAfter} and {@code margin} must be equal for all robots of a team
 * @param holdReason why it answers no calls, as a clause: an operator stopped it; null if it is not
 *     held
 */
public record RecruitmentAttributes(
    List<String> percepts,
    double speed,
    String strategy,
    double replaceAfter,
    double margin,
    @Nullable String holdReason)
    implements Attributes {

  /** The attributes of a robot that is not held. */
  public RecruitmentAttributes(
      List<String> percepts, double speed, String strategy, double replaceAfter, double margin) {
    this(percepts, speed, strategy, replaceAfter, margin, null);
  }

  public RecruitmentAttributes {
    percepts = AttributeValidation.sortedDistinct(percepts);
    AttributeValidation.requirePositive("speed", speed, "m/s");
    AttributeValidation.requireText("strategy", strategy);
    AttributeValidation.requirePositive("replaceAfter", replaceAfter, "s");
    AttributeValidation.requirePositive("margin", margin, "s");
  }
}
