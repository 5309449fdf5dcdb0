package org.dfra.persona;

import java.util.List;
import org.jspecify.annotations.Nullable;

/**
 * How an effector acts.
 *
 * @param commands names of the commands it obeys, sorted, e.g. {@code Velocity}
 * @param power electric power it draws at the most, in watts; null if not known
 * @param preconditions what its surroundings must be like, a sentence each, sorted
 */
public record EffectorAttributes(
    List<String> commands, @Nullable Double power, List<String> preconditions)
    implements Attributes {

  public EffectorAttributes {
    commands = AttributeValidation.sortedDistinct(commands);
    preconditions = AttributeValidation.sortedDistinct(preconditions);
    AttributeValidation.requireValidPower(power);
  }
}
