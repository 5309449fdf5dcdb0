package org.dfra.module;

import java.io.Serializable;

/**
 * The identification of a module.
 *
 * @param robot name of the robot the module is a part of
 * @param name name of the module, unique on its robot, in lower_snake_case
 * @param description what the module is, for display
 * @param author author of the driver
 * @param version version of the driver
 */
public record Identification(
    String robot, String name, String description, String author, String version)
    implements Serializable {

  public Identification {
    requireText("robot", robot);
    requireText("name", name);
    requireText("description", description);
    requireText("author", author);
    requireText("version", version);
  }

  /** {@code robot/name}, the module's path in messages and listings. */
  public String path() {
    return robot + "/" + name;
  }

  private static void requireText(String what, String value) {
    if (value.isBlank()) {
      throw new IllegalArgumentException(
          "a module's " + what + " is blank; give it at least one letter");
    }
  }
}
