package org.dfra.river.entry;

import org.dfra.persona.PerceptualSchemaAttributes;
import org.jspecify.annotations.Nullable;

/**
 * The reliability of a perceptual schema's percepts, see {@link PerceptualSchemaAttributes}. Null
 * is unknown, or any value in a template.
 */
@Mirrors(PerceptualSchemaAttributes.class)
public class PerceptualSchemaEntry extends ChainableEntry {

  private static final long serialVersionUID = 1L;

  /** Name of its percept type. */
  public @Nullable String percept;

  /** How its uncertainty is expressed. */
  public @Nullable String uncertainty;

  /** Its method of perception. */
  public @Nullable String method;

  /** Measured share of present objects that it detects, 0 to 1. */
  public @Nullable Double truePositiveRate;

  /** Measured share of checks without an object in which it detects one, 0 to 1. */
  public @Nullable Double falsePositiveRate;

  /** With every field null. */
  public PerceptualSchemaEntry() {}
}
