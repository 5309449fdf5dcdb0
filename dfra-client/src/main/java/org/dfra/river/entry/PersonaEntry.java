package org.dfra.river.entry;

import java.util.List;
import net.jini.entry.AbstractEntry;
import org.dfra.persona.PersonaAttributes;
import org.jspecify.annotations.Nullable;

/**
 * Attributes of a robot, see {@link PersonaAttributes}. Null is unknown, or any value in a
 * template.
 */
@Mirrors(PersonaAttributes.class)
public class PersonaEntry extends AbstractEntry {

  private static final long serialVersionUID = 1L;

  /** Name of the robot. */
  public @Nullable String robot;

  /** Its role in the team. */
  public @Nullable String role;

  /** Its goals, sorted. */
  public @Nullable List<String> goals;

  /** Its limitations, sorted. */
  public @Nullable List<String> limitations;

  /** With every field null. */
  public PersonaEntry() {}
}
