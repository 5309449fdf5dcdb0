package org.dfra.module;

import java.lang.annotation.Documented;
import java.lang.annotation.ElementType;
import java.lang.annotation.Retention;
import java.lang.annotation.RetentionPolicy;
import java.lang.annotation.Target;

/**
 * A method that may run twice without harm: a question, not a command.
 *
 * <p>When the connection breaks in the middle of such a call, it is made once more. A method
 * without this mark is never repeated, since it may have run.
 */
@Documented
@Retention(RetentionPolicy.RUNTIME)
@Target(ElementType.METHOD)
public @interface Idempotent {}
