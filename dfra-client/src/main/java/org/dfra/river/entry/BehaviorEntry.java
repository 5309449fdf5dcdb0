package org.dfra.river.entry;

import org.dfra.persona.BehaviorAttributes;
import org.jspecify.annotations.Nullable;

/**
 * Attributes of a behaviour, see {@link BehaviorAttributes}. Null is unknown, or any value in a
 * template.
 */
@Mirrors(BehaviorAttributes.class)
public class BehaviorEntry extends ChainableEntry {

  private static final long serialVersionUID = 1L;

  /** Name of its goal type. */
  public @Nullable String goal;

  /** Whether it consists of other behaviours. */
  public @Nullable Boolean script;

  /** Its present phase. */
  public @Nullable String phase;

  /** How often it evaluates its percepts, hertz. */
  public @Nullable Double rate;

  /** When an operator, a parking brake or an emergency stop held its goal, milliseconds of UTC. */
  public @Nullable Long heldSince;

  /** With every field null. */
  public BehaviorEntry() {}
}
