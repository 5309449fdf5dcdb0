package org.dfra.river.entry;

import java.util.List;
import org.dfra.persona.ChainAttributes;
import org.jspecify.annotations.Nullable;

/**
 * A module's inputs and outputs in the chain, see {@link ChainAttributes}. Null is unknown, or any
 * value in a template.
 */
@Mirrors(ChainAttributes.class)
public class ChainableEntry extends ModuleEntry {

  private static final long serialVersionUID = 1L;

  /** Names of its input types, sorted. */
  public @Nullable List<String> inputs;

  /** Names of its output types, sorted. */
  public @Nullable List<String> outputs;

  /** With every field null. */
  public ChainableEntry() {}
}
