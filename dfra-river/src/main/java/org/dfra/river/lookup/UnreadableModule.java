package org.dfra.river.lookup;

import org.dfra.text.PrintableText;

/**
 * A module whose proxy cannot be read here, most often because its classes are not trusted. The
 * other data come from its lookup service.
 *
 * @param robot name of its robot
 * @param name its name
 * @param host address of the computer it runs on
 * @param id its service ID
 * @param reason the reason and the remedy
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
