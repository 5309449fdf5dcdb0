package org.dfra.river.entry;

import net.jini.entry.AbstractEntry;
import net.jini.lookup.entry.ServiceControlled;
import org.dfra.persona.LocationAttributes;
import org.jspecify.annotations.Nullable;

/**
 * The recent approximate location of a module, see {@link LocationAttributes}. Null is unknown, or
 * any value in a template.
 */
@Mirrors(LocationAttributes.class)
public class LocationEntry extends AbstractEntry implements ServiceControlled {

  private static final long serialVersionUID = 1L;

  /** WGS84 degrees, north is +. */
  public @Nullable Double latitude;

  /** WGS84 degrees, east is +. */
  public @Nullable Double longitude;

  /** Metres above the ellipsoid. */
  public @Nullable Double height;

  /** When it was measured, in milliseconds since 1970, UTC. */
  public @Nullable Long measured;

  /** With every field null. */
  public LocationEntry() {}
}
