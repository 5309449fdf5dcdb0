package org.dfra.river.entry;

import java.lang.annotation.ElementType;
import java.lang.annotation.Retention;
import java.lang.annotation.RetentionPolicy;
import java.lang.annotation.Target;
import org.dfra.persona.Attributes;

/**
 * The record whose components the fields that an entry class itself declares stand for, by name.
 * See {@link EntryClassProvider} for classes outside this package.
 */
@Retention(RetentionPolicy.RUNTIME)
@Target(ElementType.TYPE)
public @interface Mirrors {
  /** The record. */
  Class<? extends Attributes> value();
}
