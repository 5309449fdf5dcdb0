package org.dfra.persona;

import java.util.List;
import org.jspecify.annotations.Nullable;

/**
 * As what a robot may be asked for help.
 *
 * @param percepts what it can observe, e.g. {@code mine}; sorted
 * @param speed how fast it comes, metres per second, above 0
 * @param strategy how it decides, e.g. {@code affective}
 * @param replaceAfter a helper that is late by this is replaced by another, seconds, above 0
 * @param margin so much earlier than that it turns back by itself where it is the helper, seconds,
 *     above 0; all of a team must have the same two
 * @param holdReason why it answers no call, since somebody stopped it, as a clause; null where it
 *     is not held
 */
public record RecruitmentAttributes(
    List<String> percepts,
    double speed,
    String strategy,
    double replaceAfter,
    double margin,
    @Nullable String holdReason)
    implements Attributes {

  /** Of a robot that nobody holds. */
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
