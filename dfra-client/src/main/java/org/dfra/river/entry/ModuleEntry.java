package org.dfra.river.entry;

import net.jini.entry.AbstractEntry;
import net.jini.lookup.entry.ServiceControlled;
import org.dfra.lifecycle.Readiness;
import org.dfra.persona.ModuleAttributes;
import org.jspecify.annotations.Nullable;

/**
 * Attributes of every module, see {@link ModuleAttributes}. Null is unknown, or any value in a
 * template.
 */
@Mirrors(ModuleAttributes.class)
public class ModuleEntry extends AbstractEntry implements ServiceControlled {

  private static final long serialVersionUID = 1L;

  /** Name of the robot. */
  public @Nullable String robot;

  /** Name of the module. */
  public @Nullable String name;

  /** Full name of the driver's class. */
  public @Nullable String driver;

  /** Address or name of the machine it runs on. */
  public @Nullable String host;

  /** Author of the driver. */
  public @Nullable String author;

  /** Version of the driver. */
  public @Nullable String version;

  /** Readiness of the module. */
  public @Nullable Readiness state;

  /** When it was first registered, in milliseconds since 1970, UTC. */
  public @Nullable Long created;

  /** When it was last started, in milliseconds since 1970, UTC. */
  public @Nullable Long activated;

  /** How many clients hold a lease on it. */
  public @Nullable Integer clients;

  /** With every field null. */
  public ModuleEntry() {}
}
