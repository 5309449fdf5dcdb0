package org.dfra.river.entry;

import org.dfra.persona.PerceptualSchemaAttributes;
import org.jspecify.annotations.Nullable;

/**
 * How far a perceptual schema's percepts can be trusted, see {@link PerceptualSchemaAttributes}.
 * Null is unknown, or any value in a template.
 */
@Mirrors(PerceptualSchemaAttributes.class)
public class PerceptualSchemaEntry extends ChainableEntry {

  private static final long serialVersionUID = 1L;

  /** Name of what it tells. */
  public @Nullable String percept;

  /** What its doubt is expressed by. */
  public @Nullable String uncertainty;

  /** How it perceives. */
  public @Nullable String method;

  /** Share of what is there that it finds, 0 to 1, as measured. */
  public @Nullable Double truePositiveRate;

  /** Share of its looks at nothing in which it finds something, 0 to 1. */
  public @Nullable Double falsePositiveRate;

  /** With every field null. */
  public PerceptualSchemaEntry() {}
}
