package org.dfra.persona;

/**
 * What a motor schema gives advice for.
 *
 * @param command name of the command it advises, e.g. {@code Velocity}
 * @param method how it comes to its advice, e.g. {@code mamdani}
 * @param rules how many rules it has, not negative
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
