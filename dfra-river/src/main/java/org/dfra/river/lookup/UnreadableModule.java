package org.dfra.river.lookup;

import org.dfra.text.PrintableText;

/**
 * A module whose proxy cannot be read here, most often because its classes are not trusted. What a
 * lookup service says of it is known all the same.
 *
 * @param robot name of its robot
 * @param name its name
 * @param host address of the computer it runs on
 * @param id its service ID
 * @param reason why, and what to do
 */
public record UnreadableModule(String robot, String name, String host, String id, String reason) {

  public UnreadableModule {
    robot = PrintableText.word(robot);
    name = PrintableText.word(name);
  }

  /** {@code robot/name}. */
  public String path() {
    return robot + "/" + name;
  }
}
