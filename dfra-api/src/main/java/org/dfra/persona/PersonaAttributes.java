package org.dfra.persona;

import java.util.List;
import java.util.Objects;

/**
 * A robot's role, goals and limitations.
 *
 * @param robot name of the robot
 * @param role its role in the team, e.g. {@code scout}; may be empty
 * @param goals what it tries to achieve, a sentence each, sorted
 * @param limitations what it cannot do, a sentence each, sorted
 */
public record PersonaAttributes(
    String robot, String role, List<String> goals, List<String> limitations) implements Attributes {

  public PersonaAttributes {
    AttributeValidation.requireText("robot", robot);
    Objects.requireNonNull(role, "role");
    goals = AttributeValidation.sortedDistinct(goals);
    limitations = AttributeValidation.sortedDistinct(limitations);
  }
}
