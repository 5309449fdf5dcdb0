package org.dfra.river.entry;

import java.util.List;
import org.dfra.persona.EffectorAttributes;
import org.jspecify.annotations.Nullable;

/**
 * How an effector acts, see {@link EffectorAttributes}. Null is unknown, or any value in a
 * template.
 */
@Mirrors(EffectorAttributes.class)
public class EffectorEntry extends ChainableEntry {

  private static final long serialVersionUID = 1L;

  /** Names of the commands it obeys, sorted. */
  public @Nullable List<String> commands;

  /** Electric power it draws at the most, in watts. */
  public @Nullable Double power;

  /** What its surroundings must be like, sorted. */
  public @Nullable List<String> preconditions;

  /** With every field null. */
  public EffectorEntry() {}
}
