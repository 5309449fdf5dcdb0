package org.dfra.persona;

import org.jspecify.annotations.Nullable;

/**
 * How far a perceptual schema's percepts can be trusted.
 *
 * @param percept name of what it tells, e.g. {@code PoseEstimate}
 * @param uncertainty what its doubt is expressed by, e.g. {@code covariance} or {@code
 *     probability}; null where it expresses none
 * @param method how it perceives, e.g. {@code ekf}
 * @param truePositiveRate share of what is there that it finds, 0 to 1, as measured; null where it
 *     detects nothing or nobody measured it
 * @param falsePositiveRate share of its looks at nothing in which it finds something, 0 to 1,
 *     likewise
 */
public record PerceptualSchemaAttributes(
    String percept,
    @Nullable String uncertainty,
    String method,
    @Nullable Double truePositiveRate,
    @Nullable Double falsePositiveRate)
    implements Attributes {

  public PerceptualSchemaAttributes {
    AttributeValidation.requireText("percept", percept);
    AttributeValidation.requireText("method", method);
    AttributeValidation.requireFraction("true positive rate", truePositiveRate);
    AttributeValidation.requireFraction("false positive rate", falsePositiveRate);
  }
}
