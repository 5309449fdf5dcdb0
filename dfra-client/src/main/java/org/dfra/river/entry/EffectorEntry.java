package org.dfra.river.entry;

import java.util.List;
import org.dfra.persona.EffectorAttributes;
import org.jspecify.annotations.Nullable;

/**
 * Attributes of an effector, see {@link EffectorAttributes}. Null is unknown, or any value in a
 * template.
 */
@Mirrors(EffectorAttributes.class)
public class EffectorEntry extends ChainableEntry {

  private static final long serialVersionUID = 1L;

  /** Names of the commands it executes, sorted. */
  public @Nullable List<String> commands;

  /** Maximum electric power, in watts. */
  public @Nullable Double power;

  /** Preconditions of its environment, sorted. */
  public @Nullable List<String> preconditions;

  /** With every field null. */
  public EffectorEntry() {}
}
