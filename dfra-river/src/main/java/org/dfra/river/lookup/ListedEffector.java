package org.dfra.river.lookup;

import java.util.List;
import java.util.UUID;
import org.dfra.flow.effector.Effector;
import org.dfra.persona.Attributes;
import org.dfra.text.PrintableText;
import org.jspecify.annotations.Nullable;

/**
 * An effector in a lookup service. All of it is unverified data of the registrant.
 *
 * @param id its service ID
 * @param registrar which lookup service lists it: a key of this search, since the service ID that a
 *     lookup service claims may be a copy
 * @param robot name of its robot, as a printable word
 * @param name its name on its robot, as a printable word
 * @param effector its proxy; null if it cannot be read here
 * @param attributes its attributes
 */
public record ListedEffector(
    UUID id,
    UUID registrar,
    String robot,
    String name,
    @Nullable Effector<?> effector,
    List<Attributes> attributes) {

  public ListedEffector {
    robot = PrintableText.word(robot);
    name = PrintableText.word(name);
    attributes = List.copyOf(attributes);
  }

  /** {@code robot/name}. */
  public String path() {
    return robot + "/" + name;
  }
}
