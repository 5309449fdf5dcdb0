package org.dfra.persona;

import java.util.List;

/**
 * Where a module stands in the flow from the world back into the world.
 *
 * @param inputs names of the types it takes, sorted; empty for a sensor
 * @param outputs names of the types it gives, sorted, e.g. {@code GpsFix}
 */
public record ChainAttributes(List<String> inputs, List<String> outputs) implements Attributes {

  public ChainAttributes {
    inputs = AttributeValidation.sortedDistinct(inputs);
    outputs = AttributeValidation.sortedDistinct(outputs);
  }
}
