package org.dfra.river.entry;

import java.util.List;
import org.dfra.persona.ChainAttributes;
import org.jspecify.annotations.Nullable;

/**
 * Where a module stands in the flow, see {@link ChainAttributes}. Null is unknown, or any value in
 * a template.
 */
@Mirrors(ChainAttributes.class)
public class ChainableEntry extends ModuleEntry {

  private static final long serialVersionUID = 1L;

  /** Names of the types it takes, sorted. */
  public @Nullable List<String> inputs;

  /** Names of the types it gives, sorted. */
  public @Nullable List<String> outputs;

  /** With every field null. */
  public ChainableEntry() {}
}
