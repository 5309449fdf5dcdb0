package org.dfra.persona;

import java.util.List;
import org.jspecify.annotations.Nullable;

/**
 * The commands and requirements of an effector.
 *
 * @param commands names of the commands it executes, sorted, e.g. {@code Velocity}
 * @param power maximum electric power that it draws, in watts; null if not known
 * @param preconditions required conditions of the environment, a sentence each, sorted
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
