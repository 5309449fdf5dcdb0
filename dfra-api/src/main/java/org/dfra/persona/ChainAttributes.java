package org.dfra.persona;

import java.util.List;

/**
 * The input and output types of a module in a processing chain.
 *
 * @param inputs names of its input types, sorted; empty for a sensor
 * @param outputs names of its output types, sorted, e.g. {@code GpsFix}
 */
public record ChainAttributes(List<String> inputs, List<String> outputs) implements Attributes {

  public ChainAttributes {
    inputs = AttributeValidation.sortedDistinct(inputs);
    outputs = AttributeValidation.sortedDistinct(outputs);
  }
}
