package org.dfra.persona;

/**
 * The command type and method of a motor schema.
 *
 * @param command name of the command it recommends, e.g. {@code Velocity}
 * @param method how it computes the command, e.g. {@code mamdani}
 * @param rules number of its rules, not negative
 */
public record MotorSchemaAttributes(String command, String method, int rules)
    implements Attributes {

  public MotorSchemaAttributes {
    AttributeValidation.requireText("command", command);
    AttributeValidation.requireText("method", method);
    if (rules < 0) {
      throw new IllegalArgumentException(rules + " rules are fewer than none");
    }
  }
}
