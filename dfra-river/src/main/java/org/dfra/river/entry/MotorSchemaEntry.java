package org.dfra.river.entry;

import org.dfra.persona.MotorSchemaAttributes;
import org.jspecify.annotations.Nullable;

/**
 * What a motor schema gives advice for, see {@link MotorSchemaAttributes}. Null is unknown, or any
 * value in a template.
 */
@Mirrors(MotorSchemaAttributes.class)
public class MotorSchemaEntry extends ChainableEntry {

  private static final long serialVersionUID = 1L;

  /** Name of the command it advises. */
  public @Nullable String command;

  /** How it comes to its advice. */
  public @Nullable String method;

  /** How many rules it has. */
  public @Nullable Integer rules;

  /** With every field null. */
  public MotorSchemaEntry() {}
}
