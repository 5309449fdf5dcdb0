package org.dfra.river.entry;

import java.lang.annotation.ElementType;
import java.lang.annotation.Retention;
import java.lang.annotation.RetentionPolicy;
import java.lang.annotation.Target;
import org.dfra.persona.Attributes;

/** The record whose components the fields that an entry class itself declares stand for. */
@Retention(RetentionPolicy.RUNTIME)
@Target(ElementType.TYPE)
@interface Mirrors {
  Class<? extends Attributes> value();
}
