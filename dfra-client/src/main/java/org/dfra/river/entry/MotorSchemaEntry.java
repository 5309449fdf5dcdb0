package org.dfra.river.entry;

import org.dfra.persona.MotorSchemaAttributes;
import org.jspecify.annotations.Nullable;

/**
 * The advice of a motor schema, see {@link MotorSchemaAttributes}. Null is unknown, or any value in
 * a template.
 */
@Mirrors(MotorSchemaAttributes.class)
public class MotorSchemaEntry extends ChainableEntry {

  private static final long serialVersionUID = 1L;

  /** Name of the command type that it advises on. */
  public @Nullable String command;

  /** The method by which it computes its advice. */
  public @Nullable String method;

  /** How many rules it has. */
  public @Nullable Integer rules;

  /** With every field null. */
  public MotorSchemaEntry() {}
}
