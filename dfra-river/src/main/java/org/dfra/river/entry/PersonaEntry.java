package org.dfra.river.entry;

import java.util.List;
import net.jini.entry.AbstractEntry;
import net.jini.lookup.entry.ServiceControlled;
import org.dfra.persona.PersonaAttributes;
import org.jspecify.annotations.Nullable;

/** A robot as such, see {@link PersonaAttributes}. Null is unknown, or any value in a template. */
@Mirrors(PersonaAttributes.class)
public class PersonaEntry extends AbstractEntry implements ServiceControlled {

  private static final long serialVersionUID = 1L;

  /** Name of the robot. */
  public @Nullable String robot;

  /** Its role in the team. */
  public @Nullable String role;

  /** What it tries to achieve, sorted. */
  public @Nullable List<String> goals;

  /** What it cannot do, sorted. */
  public @Nullable List<String> limitations;

  /** With every field null. */
  public PersonaEntry() {}
}
