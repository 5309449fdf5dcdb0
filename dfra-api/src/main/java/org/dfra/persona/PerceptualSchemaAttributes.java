package org.dfra.persona;

import org.jspecify.annotations.Nullable;

/**
 * The percept type of a perceptual schema, and its accuracy.
 *
 * @param percept name of its percept type, e.g. {@code PoseEstimate}
 * @param uncertainty the kind of uncertainty, e.g. {@code covariance} or {@code probability}; null
 *     if it states none
 * @param method how it perceives, e.g. {@code ekf}
 * @param truePositiveRate measured fraction of existing objects that it detects, 0 to 1; null if it
 *     is not a detector or was not measured
 * @param falsePositiveRate measured fraction of observations without an object in which it reports
 *     one, 0 to 1, likewise
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
