package org.dfra.river.entry;

import net.jini.entry.AbstractEntry;
import net.jini.lookup.entry.ServiceControlled;
import org.dfra.persona.PoseAttributes;
import org.jspecify.annotations.Nullable;

/**
 * The mounting pose of a module, see {@link PoseAttributes}. Null is unknown, or any value in a
 * template.
 */
@Mirrors(PoseAttributes.class)
public class PoseEntry extends AbstractEntry implements ServiceControlled {

  private static final long serialVersionUID = 1L;

  /** Name of the module's frame. */
  public @Nullable String frame;

  /** Name of the frame it is mounted on. */
  public @Nullable String parent;

  /** Metres, forward is +. */
  public @Nullable Double x;

  /** Metres, left is +. */
  public @Nullable Double y;

  /** Metres, up is +. */
  public @Nullable Double z;

  /** Radians about x. */
  public @Nullable Double roll;

  /** Radians about y. */
  public @Nullable Double pitch;

  /** Radians about z. */
  public @Nullable Double yaw;

  /** With every field null. */
  public PoseEntry() {}
}
