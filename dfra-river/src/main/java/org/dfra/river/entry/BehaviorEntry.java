package org.dfra.river.entry;

import org.dfra.persona.BehaviorAttributes;
import org.jspecify.annotations.Nullable;

/**
 * What a behaviour is for, see {@link BehaviorAttributes}. Null is unknown, or any value in a
 * template.
 */
@Mirrors(BehaviorAttributes.class)
public class BehaviorEntry extends ChainableEntry {

  private static final long serialVersionUID = 1L;

  /** Name of what it can reach. */
  public @Nullable String goal;

  /** Whether it is made of other behaviours. */
  public @Nullable Boolean script;

  /** What it is at. */
  public @Nullable String phase;

  /** How often it looks at its percepts, hertz. */
  public @Nullable Double rate;

  /** When a person, a parking brake or an emergency stop stopped its goal, milliseconds of UTC. */
  public @Nullable Long heldSince;

  /** With every field null. */
  public BehaviorEntry() {}
}
