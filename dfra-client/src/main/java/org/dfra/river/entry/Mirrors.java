package org.dfra.river.entry;

import java.lang.annotation.ElementType;
import java.lang.annotation.Retention;
import java.lang.annotation.RetentionPolicy;
import java.lang.annotation.Target;
import org.dfra.persona.Attributes;

/**
 * The record that an entry class mirrors: each field that the class declares has the name of a
 * component. See {@link EntryClassProvider} for classes outside this package.
 */
@Retention(RetentionPolicy.RUNTIME)
@Target(ElementType.TYPE)
public @interface Mirrors {
  /** The record. */
  Class<? extends Attributes> value();
}
